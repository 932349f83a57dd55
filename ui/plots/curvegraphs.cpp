#include "ui/plots/curvegraphs.h"

#include "ui/plots/plottime.h"
#include "ui/plots/seriesfeed.h"

#include <limits>

namespace gorizont {

namespace {

using Dots = QVector<QCPGraphData>;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr float bandOpacity = 0.22F;

void give(QCPGraph *graph, const Dots &points)
{
    graph->data()->set(points, true);
}

} // namespace

struct CurveGraphs::Points
{
    Dots line;
    Dots lowest;
    Dots highest;
    Dots dots;
    int inARow = 0; ///< values since the last break
};

CurveGraphs::CurveGraphs(QCustomPlot &plot, QCPAxis *values, const QString &title, const CurveStyle &style)
    : m_lowest(plot.addGraph(plot.xAxis, values))
    , m_highest(plot.addGraph(plot.xAxis, values))
    , m_line(plot.addGraph(plot.xAxis, values))
    , m_dots(plot.addGraph(plot.xAxis, values))
{
    QColor band = style.colour;
    band.setAlphaF(bandOpacity);
    for (QCPGraph *graph : {m_lowest, m_highest, m_dots}) {
        graph->removeFromLegend();
        graph->setPen(Qt::NoPen);
        graph->setAntialiased(false);
    }
    m_highest->setBrush(band);
    m_highest->setChannelFillGraph(m_lowest);
    m_dots->setPen(QPen(style.colour));
    m_dots->setLineStyle(QCPGraph::lsNone);
    m_dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4));
    m_line->setPen(QPen(style.colour, 1, style.line));
    m_line->setName(title);
}

void CurveGraphs::breakAt(Points &points, double key)
{
    if (points.inARow == 0) {
        return;
    }
    if (points.inARow == 1) {
        points.dots.append(points.line.constLast());
    }
    points.line.append({key, nothing});
    points.lowest.append({key, nothing});
    points.highest.append({key, nothing});
    points.inARow = 0;
}

/// A gap within a bucket that still has values is no break: the line goes from the middle of a bucket to the next.
void CurveGraphs::setHistory(const Series &series, double scale)
{
    m_scale = scale;
    Points points;
    points.line.reserve(series.buckets.size());
    const double half = std::chrono::duration<double>(series.step).count() / 2;
    auto gap = series.gaps.cbegin();
    const auto passGaps = [&](UtcTime until) {
        for (; gap != series.gaps.cend() && gap->from < until; ++gap) {
            if (gap->to - gap->from >= series.step) {
                breakAt(points, toKey(gap->from) + half);
            }
        }
    };
    UtcTime last;
    for (const SeriesBucket &bucket : series.buckets) {
        passGaps(bucket.from + std::chrono::microseconds(1));
        const bool isMissing = series.step.count() > 0 && bucket.from - last > series.step + series.step / 2;
        if (isMissing || bucket.valid == 0) {
            breakAt(points, toKey(last + series.step) + half);
        }
        last = bucket.from;
        if (bucket.valid > 0) {
            const double key = toKey(bucket.from) + half;
            points.line.append({key, bucket.mean * scale});
            if (series.step.count() > 0) {
                points.lowest.append({key, bucket.minimum * scale});
                points.highest.append({key, bucket.maximum * scale});
            }
            ++points.inARow;
        }
    }
    passGaps(UtcTime::max());
    m_end = series.buckets.isEmpty() ? UtcTime::min() : last + series.step;
    draw(points, series.step.count() > 0);
}

void CurveGraphs::draw(const Points &points, bool hasBand)
{
    m_hasBand = hasBand;
    m_fromHistory = points.line.size();
    forgetExtremes();
    give(m_line, points.line);
    give(m_dots, points.dots);
    give(m_lowest, hasBand ? points.lowest : Dots());
    give(m_highest, hasBand ? points.highest : Dots());
}

void CurveGraphs::append(const QList<SeriesBucket> &live)
{
    auto first = live.cend();
    while (first != live.cbegin() && (first - 1)->from > m_end) {
        --first;
    }
    for (; first != live.cend(); ++first) {
        const double key = toKey(first->from);
        const double value = first->valid > 0 ? first->mean * m_scale : nothing;
        m_line->data()->add(QCPGraphData(key, value));
        if (m_hasBand) {
            m_lowest->data()->add(QCPGraphData(key, value));
            m_highest->data()->add(QCPGraphData(key, value));
        }
        m_end = first->from;
    }
    if (m_line->dataCount() > m_fromHistory + SeriesFeed::mostLive) {
        forgetOldest();
    }
}

void CurveGraphs::forgetOldest()
{
    const double first = m_line->data()->at(static_cast<int>(SeriesFeed::mostLive / 10))->key;
    for (QCPGraph *graph : {m_lowest, m_highest, m_line, m_dots}) {
        graph->data()->removeBefore(first);
    }
    forgetExtremes();
}

void CurveGraphs::forgetExtremes()
{
    for (LineExtremes *extremes : {&m_lineExtremes, &m_lowestExtremes, &m_highestExtremes}) {
        extremes->forget();
    }
}

std::optional<QCPRange> CurveGraphs::valueRange(const QCPRange &keys) const
{
    std::optional<QCPRange> range = m_lineExtremes.within(*m_line->data(), keys);
    if (range && m_hasBand) {
        range->expand(m_lowestExtremes.within(*m_lowest->data(), keys).value_or(*range));
        range->expand(m_highestExtremes.within(*m_highest->data(), keys).value_or(*range));
    }
    return range;
}

} // namespace gorizont
