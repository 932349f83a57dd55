#include "ui/displacement/profileplot.h"

#include "ui/displacement/profilezero.h"
#include "ui/models/colours.h"
#include "ui/plots/plotlook.h"
#include "ui/plots/plotting.h"

namespace gorizont {

ProfilePlot::ProfilePlot(Plane plane, QWidget *parent)
    : QWidget(parent)
    , m_plane(plane)
    , m_plot(new QCustomPlot(this))
    , m_now(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
    , m_zero(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
{
    setObjectName(plane == Plane::X ? QStringLiteral("profileX") : QStringLiteral("profileY"));
    setMinimumSize(220, 200);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->xAxis->setLabel(plane == Plane::X ? tr("Displacement along X, mm") : tr("Displacement along Y, mm"));
    m_plot->yAxis->setLabel(tr("Height, m"));
    m_now->setName(tr("now"));
    m_zero->setName(tr("zero"));
    // The corner that a building hardly ever reaches.
    m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | Qt::AlignRight);
    dress();
    m_plot->installEventFilter(this);
}

void ProfilePlot::dress()
{
    plotlook::dress(*m_plot);
    const QPalette &look = palette();
    m_plot->xAxis->grid()->setZeroLinePen(QPen(look.color(QPalette::Text), 0));
    m_now->setPen(QPen(look.color(QPalette::Highlight), 2));
    m_now->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 7));
    m_zero->setPen(QPen(colours::mutedText(look), 1.5, Qt::DashLine));
    m_zero->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, 6));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

/// Of the plot: it gets a palette after the widget around it.
bool ProfilePlot::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        dress();
    }
    return QWidget::eventFilter(watched, event);
}

void ProfilePlot::show(const std::vector<ChainNode> &nodes, const ProfileZero *zero)
{
    QVector<double> shifts{0};
    QVector<double> heights{0};
    for (const ChainNode &node : nodes) {
        if (!node.sum) {
            break;
        }
        shifts.append(part(*node.sum));
        heights.append(node.height);
    }
    m_now->setData(shifts, heights);
    QVector<double> zeroShifts{0};
    QVector<double> zeroHeights{0};
    for (const ChainNode &node : nodes) {
        const auto at = zero != nullptr ? zero->at(node) : std::nullopt;
        if (at) {
            zeroShifts.append(part(*at));
            zeroHeights.append(node.height);
        }
    }
    m_zero->setVisible(zero != nullptr);
    m_plot->legend->setVisible(zero != nullptr);
    m_zero->setData(zeroShifts, zeroHeights);
    fit(nodes);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

/// Zero in the middle and steps of a round size: a building at rest must not dance with its noise.
void ProfilePlot::fit(const std::vector<ChainNode> &nodes)
{
    constexpr double least = 1; // mm
    double extent = least;
    for (const QCPCurve *curve : {m_now, m_zero}) {
        for (const QCPCurveData &point : *curve->data()) {
            extent = std::max(extent, 1.15 * std::abs(point.key));
        }
    }
    const double decade = std::pow(10, std::floor(std::log10(extent)));
    const double steps = extent / decade;
    const double round = (steps <= 2 ? 2 : steps <= 5 ? 5 : 10) * decade;
    m_plot->xAxis->setRange(-round, round);
    m_plot->yAxis->setRange(0, nodes.empty() ? 1 : 1.05 * nodes.back().height);
}

} // namespace gorizont
