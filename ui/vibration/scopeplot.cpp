#include "ui/vibration/scopeplot.h"

#include "ui/plots/plotlook.h"

namespace gorizont {

namespace {

constexpr double zoomStep = 1.5;
constexpr double moveStep = 0.1; ///< of what is seen
constexpr double smallestShare = 1e-4; ///< of the whole that can be seen
constexpr double air = 0.08; ///< above and below the values
constexpr double leastScale = 1e-12;

} // namespace

ScopePlot::ScopePlot(QWidget *parent)
    : QCustomPlot(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setNoAntialiasingOnDrag(true);
    setPlottingHints(QCP::PlottingHints(QCP::phFastPolylines) | QCP::phCacheLabels);
    plotlook::dress(*this);
}

void ScopePlot::setWhole(const QCPRange &whole)
{
    if (whole != m_whole) {
        m_whole = whole;
        showWhole();
    }
}

void ScopePlot::showWhole()
{
    showRange(m_whole);
}

void ScopePlot::showRange(const QCPRange &range)
{
    const double size = std::clamp(range.size(), smallestShare * m_whole.size(), m_whole.size());
    const double middle = range.center();
    const double lower = std::clamp(middle - size / 2, m_whole.lower, m_whole.upper - size);
    xAxis->setRange(lower, lower + size);
    fit();
    Q_EMIT rangeSeen();
}

void ScopePlot::fit()
{
    std::optional<QCPRange> seen;
    for (int i = 0; i < graphCount(); ++i) {
        bool isFound = false;
        const QCPRange range = graph(i)->getValueRange(isFound, QCP::sdBoth, xAxis->range());
        if (isFound && graph(i)->visible()) {
            seen = seen ? seen->expanded(range) : range;
        }
    }
    if (seen) {
        const double lower = m_fromZero ? 0 : seen->lower;
        const double size = std::max(seen->upper - lower, leastScale);
        yAxis->setRange(m_fromZero ? 0 : lower - air * size, lower + size * (1 + (m_fromZero ? 2 : 1) * air));
    }
    replot(QCustomPlot::rpQueuedReplot);
}

void ScopePlot::zoom(double factor, double about)
{
    const QCPRange range = xAxis->range();
    const double size = std::min(range.size() * factor, m_whole.size());
    const double share = (about - range.lower) / range.size();
    showRange({about - share * size, about + (1 - share) * size});
}

void ScopePlot::move(double share)
{
    showRange(xAxis->range() + share * xAxis->range().size());
}

void ScopePlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton) {
        m_drag = Drag{event->position().x(), xAxis->range()};
        setCursor(Qt::ClosedHandCursor);
    }
}

void ScopePlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_drag) {
        const double pixels = m_drag->start - event->position().x();
        showRange(m_drag->range + pixels * m_drag->range.size() / std::max(1, axisRect()->width()));
    }
}

void ScopePlot::mouseReleaseEvent(QMouseEvent *)
{
    m_drag.reset();
    unsetCursor();
}

void ScopePlot::mouseDoubleClickEvent(QMouseEvent *)
{
    showWhole();
}

void ScopePlot::wheelEvent(QWheelEvent *event)
{
    const bool isSideways = event->angleDelta().x() != 0 || event->modifiers() & Qt::ShiftModifier;
    const int delta = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double steps = delta / static_cast<double>(QWheelEvent::DefaultDeltasPerStep);
    if (isSideways) {
        move(-steps * moveStep);
    } else {
        zoom(std::pow(zoomStep, -steps), xAxis->pixelToCoord(event->position().x()));
    }
    event->accept();
}

void ScopePlot::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left: return move(-moveStep);
    case Qt::Key_Right: return move(moveStep);
    case Qt::Key_PageUp: return move(-1);
    case Qt::Key_PageDown: return move(1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Up: return zoom(1 / zoomStep, xAxis->range().center());
    case Qt::Key_Minus:
    case Qt::Key_Down: return zoom(zoomStep, xAxis->range().center());
    case Qt::Key_Home: return showWhole();
    default: QCustomPlot::keyPressEvent(event);
    }
}

void ScopePlot::changeEvent(QEvent *event)
{
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        plotlook::dress(*this);
        replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace gorizont
