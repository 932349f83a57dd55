#include "ui/plots/cursorlines.h"

#include "ui/plots/plotting.h"

namespace gorizont {

namespace {

constexpr double reach = 6; ///< pixels at which the mouse takes hold

} // namespace

CursorLines::CursorLines(QCustomPlot *plot)
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

void CursorLines::setShown(bool isShown)
{
    m_isShown = isShown;
    const QCPRange seen = m_plot->xAxis->range();
    const bool isOutOfSight =
        !m_isPlaced || std::none_of(m_keys.cbegin(), m_keys.cend(), [&seen](double key) { return seen.contains(key); });
    if (isShown && isOutOfSight) {
        m_isPlaced = true;
        m_keys = {seen.lower + seen.size() / 3, seen.lower + seen.size() * 2 / 3};
    }
    draw();
    Q_EMIT moved();
}

void CursorLines::placeAt(double first, double second)
{
    m_keys = {first, second};
    m_isPlaced = true;
    draw();
    Q_EMIT moved();
}

void CursorLines::draw()
{
    const QColor text = m_plot->palette().color(QPalette::Text);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const double key = m_keys[i];
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

bool CursorLines::press(const QPointF &position)
{
    double nearest = reach;
    for (int i = 0; i < 2; ++i) {
        const double pixel = m_plot->xAxis->coordToPixel(m_keys.at(static_cast<std::size_t>(i)));
        if (std::abs(pixel - position.x()) <= nearest && m_plot->axisRect()->rect().contains(position.toPoint())) {
            nearest = std::abs(pixel - position.x());
            m_dragged = i;
        }
    }
    return m_dragged >= 0;
}

bool CursorLines::moveByKey(int key, Qt::KeyboardModifiers modifiers)
{
    const bool isLeft = key == Qt::Key_Left;
    if ((!isLeft && key != Qt::Key_Right) || !(modifiers & (Qt::ControlModifier | Qt::ShiftModifier))) {
        return false;
    }
    const double pixel = m_plot->xAxis->range().size() / std::max(1, m_plot->axisRect()->width());
    std::array<double, 2> keys = m_keys;
    keys[modifiers & Qt::ControlModifier ? 0 : 1] += isLeft ? -pixel : pixel;
    placeAt(keys[0], keys[1]);
    return true;
}

bool CursorLines::eventFilter(QObject *, QEvent *event)
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
            std::array<double, 2> keys = m_keys;
            keys.at(static_cast<std::size_t>(m_dragged)) = m_plot->xAxis->pixelToCoord(pixel);
            placeAt(keys[0], keys[1]);
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
