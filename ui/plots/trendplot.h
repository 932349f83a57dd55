#pragma once

#include "ui/plots/curvegraphs.h"
#include "ui/plots/plottext.h"
#include "ui/plots/timeplot.h"

#include <map>

namespace gorizont {

/// One curve of a trend.
struct TrendCurve
{
    SeriesKey key;
    QString title;
    CurveStyle style;
    bool operator==(const TrendCurve &) const = default;
};

/// Curves over time with an axis for every unit, left and right in turn, and their names above. GUI thread.
class TrendPlot : public TimePlot
{
    Q_OBJECT

public:
    explicit TrendPlot(QWidget *parent = nullptr);

    void setCurves(const QList<TrendCurve> &curves, TiltUnit unit);

    /// All that is known of a curve; other keys are ignored.
    void setSeries(const Series &history, const QList<SeriesBucket> &live);
    void append(const SeriesKey &key, const QList<SeriesBucket> &live);

    /// Lets every scale that nobody has set by hand hold what is seen now.
    void fitScales();

    /// Something is drawn within the span.
    bool hasValues() const;

    /// The axis that a quantity is drawn on; null: none of its unit is drawn.
    QCPAxis *axisOf(ValueAxis axis) const;
    const CurveGraphs *graphsOf(const SeriesKey &key) const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildAxes(const QList<ValueAxis> &wanted);
    void arrangeLegend();

    TiltUnit m_unit = TiltUnit::Degrees;
    std::map<ValueAxis, QCPAxis *> m_axes;
    std::map<SeriesKey, CurveGraphs> m_graphs;
};

} // namespace gorizont
