#include "ui/plots/timeplot.h"

#include "ui/plots/plotlook.h"
#include "ui/plots/plottime.h"
#include "ui/plots/timeticker.h"

namespace gorizont {

namespace {

constexpr double shortestSpan = 0.5; ///< seconds
constexpr double longestSpan = 40 * 366 * 86400.0;
constexpr double earliest = 0; ///< 1970
constexpr double latest = 4102444800; ///< 2100
constexpr double zoomStep = 1.5;
constexpr double moveStep = 0.1; ///< of the span

} // namespace

TimePlot::TimePlot(QWidget *parent)
    : QCustomPlot(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setNoAntialiasingOnDrag(true);
    setPlottingHints(QCP::PlottingHints(QCP::phFastPolylines) | QCP::phCacheLabels);
    xAxis->setTicker(QSharedPointer<TimeTicker>::create());
    xAxis->ticker()->setTickCount(6);
    plotlook::dress(*this);
    connect(xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this, &TimePlot::spanChanged);
}

TimeSpan TimePlot::span() const
{
    return {toTime(xAxis->range().lower), toTime(xAxis->range().upper)};
}

void TimePlot::setSpan(const TimeSpan &span)
{
    showKeys(toKey(span.from), toKey(span.to));
}

int TimePlot::plotWidth() const
{
    return axisRect()->width();
}

/// The length of a span that leaves the calendar is kept.
void TimePlot::showKeys(double lower, double upper)
{
    const double middle = (lower + upper) / 2;
    const double size = std::clamp(upper - lower, shortestSpan, longestSpan);
    const double begin = std::clamp(middle - size / 2, earliest, latest - size);
    xAxis->setRange(begin, begin + size);
    replot(QCustomPlot::rpQueuedReplot);
}

void TimePlot::zoomAbout(double factor, double key)
{
    const QCPRange range = xAxis->range();
    const double size = std::clamp(range.size() * factor, shortestSpan, longestSpan);
    const double share = (key - range.lower) / range.size();
    showKeys(key - share * size, key + (1 - share) * size);
    Q_EMIT movedByHand();
}

void TimePlot::zoom(double factor)
{
    zoomAbout(factor, m_keepsEnd ? xAxis->range().upper : xAxis->range().center());
}

void TimePlot::move(double share)
{
    const QCPRange range = xAxis->range();
    showKeys(range.lower + share * range.size(), range.upper + share * range.size());
    Q_EMIT movedByHand();
}

void TimePlot::letScalesFit()
{
    m_byHand.clear();
    Q_EMIT fitWanted();
}

void TimePlot::scaleByHand(QCPAxis *axis, const QCPRange &range)
{
    m_byHand.insert(axis);
    axis->setRange(range);
    replot(QCustomPlot::rpQueuedReplot);
}

QCPAxis *TimePlot::valueAxisAt(const QPointF &position) const
{
    for (QCPAxis *axis : axisRect()->axes(QCPAxis::atLeft | QCPAxis::atRight)) {
        if (axis->visible() && axis->selectTest(position, false) >= 0) {
            return axis;
        }
    }
    return nullptr;
}

void TimePlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton) {
        QCPAxis *axis = valueAxisAt(event->position());
        m_drag = Drag{event->position(), axis, axis ? axis->range() : xAxis->range()};
        setCursor(axis ? Qt::SizeVerCursor : Qt::ClosedHandCursor);
    }
}

void TimePlot::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_drag) {
        return;
    }
    if (QCPAxis *axis = m_drag->axis) {
        const double shift = axis->pixelToCoord(m_drag->start.y()) - axis->pixelToCoord(event->position().y());
        scaleByHand(axis, m_drag->range + shift);
        return;
    }
    const double pixels = m_drag->start.x() - event->position().x();
    const double shift = pixels * m_drag->range.size() / std::max(1, plotWidth());
    showKeys(m_drag->range.lower + shift, m_drag->range.upper + shift);
    Q_EMIT movedByHand();
}

void TimePlot::mouseReleaseEvent(QMouseEvent *)
{
    m_drag.reset();
    unsetCursor();
}

void TimePlot::mouseDoubleClickEvent(QMouseEvent *)
{
    letScalesFit();
}

void TimePlot::wheelEvent(QWheelEvent *event)
{
    const bool isSideways = event->angleDelta().x() != 0 || event->modifiers() & Qt::ShiftModifier;
    const int delta = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double steps = delta / static_cast<double>(QWheelEvent::DefaultDeltasPerStep);
    const double factor = std::pow(zoomStep, -steps);
    if (isSideways) {
        move(-steps * moveStep);
    } else if (QCPAxis *axis = valueAxisAt(event->position())) {
        QCPRange range = axis->range();
        const double center = axis->pixelToCoord(event->position().y());
        range.lower = center + (range.lower - center) * factor;
        range.upper = center + (range.upper - center) * factor;
        scaleByHand(axis, range);
    } else {
        zoomAbout(factor, m_keepsEnd ? xAxis->range().upper : xAxis->pixelToCoord(event->position().x()));
    }
    event->accept();
}

void TimePlot::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left: return move(-moveStep);
    case Qt::Key_Right: return move(moveStep);
    case Qt::Key_PageUp: return move(-1);
    case Qt::Key_PageDown: return move(1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Up: return zoom(1 / zoomStep);
    case Qt::Key_Minus:
    case Qt::Key_Down: return zoom(zoomStep);
    case Qt::Key_Home: Q_EMIT beginningWanted(); return;
    case Qt::Key_End: Q_EMIT endWanted(); return;
    default: QCustomPlot::keyPressEvent(event);
    }
}

void TimePlot::changeEvent(QEvent *event)
{
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        plotlook::dress(*this);
        replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace gorizont
