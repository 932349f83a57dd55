#include "ui/plots/trendplot.h"

#include "ui/plots/plotlook.h"

namespace gorizont {

namespace {

constexpr double airOfScale = 0.06; ///< above and below the curves
constexpr int longestTitle = 320; ///< pixels of a name above the plot

/// The least a scale spans, so that the noise of the last digit does not look like an earthquake.
double leastSpan(ValueAxis axis, TiltUnit unit)
{
    if (axis == ValueAxis::Tilt) {
        return unit == TiltUnit::Degrees ? 0.0005 : 2;
    }
    return 0.1;
}

} // namespace

TrendPlot::TrendPlot(QWidget *parent)
    : TimePlot(parent)
{
    axisRect()->insetLayout()->take(legend);
    legend->setFillOrder(QCPLegend::foColumnsFirst);
    legend->setMargins(QMargins(6, 4, 6, 0));
    legend->setRowSpacing(0);
    plotlook::dress(*this);
    setCurves({}, m_unit);
    connect(this, &TimePlot::fitWanted, this, [this] {
        fitScales();
        replot(QCustomPlot::rpQueuedReplot);
    });
}

void TrendPlot::setCurves(const QList<TrendCurve> &curves, TiltUnit unit)
{
    m_unit = unit;
    m_graphs.clear();
    clearGraphs();
    QList<ValueAxis> wanted;
    for (const TrendCurve &curve : curves) {
        const ValueAxis axis = plottext::axisOf(curve.key.quantity);
        if (!wanted.contains(axis)) {
            wanted.append(axis);
        }
    }
    buildAxes(wanted);
    for (const TrendCurve &curve : curves) {
        QCPAxis *axis = m_axes.at(plottext::axisOf(curve.key.quantity));
        const QString title = fontMetrics().elidedText(curve.title, Qt::ElideMiddle, longestTitle);
        m_graphs.try_emplace(curve.key, *this, axis, title, curve.style);
    }
    arrangeLegend();
    replot(QCustomPlot::rpQueuedReplot);
}

void TrendPlot::buildAxes(const QList<ValueAxis> &wanted)
{
    forgetScales();
    m_axes.clear();
    for (QCPAxis *axis : axisRect()->axes(QCPAxis::atLeft | QCPAxis::atRight)) {
        if (axis != yAxis && axis != yAxis2) {
            axisRect()->removeAxis(axis);
        }
    }
    yAxis2->setVisible(wanted.size() > 1);
    yAxis2->setTickLabels(true);
    for (qsizetype i = 0; i < wanted.size(); ++i) {
        const QCPAxis::AxisType side = i % 2 == 0 ? QCPAxis::atLeft : QCPAxis::atRight;
        QCPAxis *axis = i == 0 ? yAxis : (i == 1 ? yAxis2 : axisRect()->addAxis(side));
        plotlook::dress(*axis, *this);
        axis->setLabel(plottext::axisTitle(wanted.at(i), m_unit));
        axis->setNumberFormat(QStringLiteral("g"));
        axis->setNumberPrecision(7);
        axis->grid()->setVisible(i == 0);
        m_axes[wanted.at(i)] = axis;
    }
    if (wanted.isEmpty()) {
        yAxis->setLabel({});
    }
}

/// As many columns as the widest name allows. Without names it is taken out: it would narrow the plot to nothing.
void TrendPlot::arrangeLegend()
{
    const bool isPlaced = legend->layout() == plotLayout();
    const bool isWanted = legend->itemCount() > 0;
    if (isWanted && !isPlaced) {
        plotLayout()->insertRow(0);
        plotLayout()->addElement(0, 0, legend);
        plotLayout()->setRowStretchFactor(0, 0.001);
    } else if (!isWanted && isPlaced) {
        plotLayout()->take(legend);
        plotLayout()->simplify();
    }
    legend->setVisible(isWanted);
    int widest = 1;
    for (int i = 0; i < legend->itemCount(); ++i) {
        widest = std::max(widest, legend->item(i)->minimumOuterSizeHint().width() + legend->columnSpacing());
    }
    const int columns = std::max(1, (width() - 12) / widest);
    if (legend->wrap() != columns) {
        legend->setWrap(columns);
        legend->setFillOrder(QCPLegend::foColumnsFirst, true);
    }
}

void TrendPlot::resizeEvent(QResizeEvent *event)
{
    arrangeLegend();
    TimePlot::resizeEvent(event);
}

void TrendPlot::setSeries(const Series &history, const QList<SeriesBucket> &live)
{
    const auto found = m_graphs.find(history.key);
    if (found != m_graphs.end()) {
        found->second.setHistory(history, plottext::scaleOf(history.key.quantity, m_unit));
        found->second.append(live);
    }
}

void TrendPlot::append(const SeriesKey &key, const QList<SeriesBucket> &live)
{
    const auto found = m_graphs.find(key);
    if (found != m_graphs.end()) {
        found->second.append(live);
    }
}

void TrendPlot::fitScales()
{
    for (const auto &[kind, axis] : m_axes) {
        std::optional<QCPRange> range;
        for (const auto &[key, graphs] : m_graphs) {
            if (plottext::axisOf(key.quantity) == kind) {
                if (const std::optional<QCPRange> own = graphs.valueRange(xAxis->range())) {
                    range = range ? range->expanded(*own) : *own;
                }
            }
        }
        if (!range || isScaledByHand(axis)) {
            continue;
        }
        const double size = std::max(range->size() * (1 + 2 * airOfScale), leastSpan(kind, m_unit));
        axis->setRange(range->center() - size / 2, range->center() + size / 2);
    }
}

bool TrendPlot::hasValues() const
{
    return std::any_of(m_graphs.cbegin(), m_graphs.cend(), [this](const auto &entry) {
        return entry.second.valueRange(xAxis->range()).has_value();
    });
}

QCPAxis *TrendPlot::axisOf(ValueAxis axis) const
{
    const auto found = m_axes.find(axis);
    return found == m_axes.end() ? nullptr : found->second;
}

const CurveGraphs *TrendPlot::graphsOf(const SeriesKey &key) const
{
    const auto found = m_graphs.find(key);
    return found == m_graphs.end() ? nullptr : &found->second;
}

} // namespace gorizont
