#include "ui/plots/cursorpair.h"

#include "ui/plots/plottime.h"
#include "ui/plots/timeplot.h"

namespace gorizont {

namespace {

constexpr double reach = 6; ///< pixels at which the mouse takes hold

} // namespace

CursorPair::CursorPair(TimePlot *plot)
    : QObject(plot)
    , m_plot(plot)
{
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        m_lines[i] = new QCPItemStraightLine(plot);
        m_labels[i] = new QCPItemText(plot);
        for (QCPItemPosition *position : {m_lines[i]->point1, m_lines[i]->point2, m_labels[i]->position}) {
            position->setTypeX(QCPItemPosition::ptPlotCoords);
            position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        }
        m_labels[i]->setText(i == 0 ? QStringLiteral("A") : QStringLiteral("B"));
        m_labels[i]->setPositionAlignment(Qt::AlignTop | Qt::AlignHCenter);
        m_labels[i]->setPadding(QMargins(4, 1, 4, 1));
        m_lines[i]->setVisible(false);
        m_labels[i]->setVisible(false);
    }
    plot->installEventFilter(this);
}

void CursorPair::setShown(bool isShown)
{
    m_isShown = isShown;
    const TimeSpan seen = m_plot->span();
    const bool isOutOfSight = std::all_of(m_times.cbegin(), m_times.cend(), [&seen](UtcTime time) {
        return time < seen.from || time > seen.to;
    });
    if (isShown && isOutOfSight) {
        m_times = {seen.from + (seen.to - seen.from) / 3, seen.from + (seen.to - seen.from) * 2 / 3};
    }
    draw();
    Q_EMIT moved();
}

void CursorPair::place(UtcTime first, UtcTime second)
{
    m_times = {first, second};
    draw();
    Q_EMIT moved();
}

void CursorPair::draw()
{
    const QColor text = m_plot->palette().color(QPalette::Text);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const double key = toKey(m_times[i]);
        m_lines[i]->point1->setCoords(key, 0);
        m_lines[i]->point2->setCoords(key, 1);
        m_labels[i]->position->setCoords(key, 0);
        m_lines[i]->setPen(QPen(text, 1));
        m_labels[i]->setColor(m_plot->palette().color(QPalette::Base));
        m_labels[i]->setBrush(text);
        m_lines[i]->setVisible(m_isShown);
        m_labels[i]->setVisible(m_isShown);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

bool CursorPair::press(const QPointF &position)
{
    double nearest = reach;
    for (int i = 0; i < 2; ++i) {
        const double pixel = m_plot->xAxis->coordToPixel(toKey(m_times.at(static_cast<std::size_t>(i))));
        if (std::abs(pixel - position.x()) <= nearest && m_plot->axisRect()->rect().contains(position.toPoint())) {
            nearest = std::abs(pixel - position.x());
            m_dragged = i;
        }
    }
    return m_dragged >= 0;
}

bool CursorPair::moveByKey(int key, Qt::KeyboardModifiers modifiers)
{
    const bool isLeft = key == Qt::Key_Left;
    if ((!isLeft && key != Qt::Key_Right) || !(modifiers & (Qt::ControlModifier | Qt::ShiftModifier))) {
        return false;
    }
    const TimeSpan seen = m_plot->span();
    const std::chrono::microseconds pixel = (seen.to - seen.from) / std::max(1, m_plot->plotWidth());
    std::array<UtcTime, 2> times = m_times;
    times[modifiers & Qt::ControlModifier ? 0 : 1] += isLeft ? -pixel : pixel;
    place(times[0], times[1]);
    return true;
}

bool CursorPair::eventFilter(QObject *, QEvent *event)
{
    if (event->type() == QEvent::PaletteChange) {
        draw();
    }
    if (!m_isShown) {
        return false;
    }
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        return mouse->button() == Qt::LeftButton && press(mouse->position());
    }
    case QEvent::MouseMove:
        if (m_dragged >= 0) {
            const double pixel = static_cast<QMouseEvent *>(event)->position().x();
            std::array<UtcTime, 2> times = m_times;
            times.at(static_cast<std::size_t>(m_dragged)) = toTime(m_plot->xAxis->pixelToCoord(pixel));
            place(times[0], times[1]);
            return true;
        }
        return false;
    case QEvent::MouseButtonRelease: return std::exchange(m_dragged, -1) >= 0;
    case QEvent::KeyPress: {
        const auto *key = static_cast<QKeyEvent *>(event);
        return moveByKey(key->key(), key->modifiers());
    }
    default: return false;
    }
}

} // namespace gorizont
