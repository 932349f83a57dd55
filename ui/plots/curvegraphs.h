#pragma once

#include "core/values/series.h"
#include "ui/plots/curvestyle.h"
#include "ui/plots/lineextremes.h"
#include "ui/plots/plotting.h"

namespace gorizont {

/// What one curve is drawn with: the line of the means, the band between minimum and maximum where a bucket holds more
/// than one reading, and a dot where a value stands alone between two gaps. The plot owns the graphs. GUI thread.
class CurveGraphs
{
public:
    CurveGraphs(QCustomPlot &plot, QCPAxis *values, const QString &title, const CurveStyle &style);

    /// What is drawn = value × \a scale.
    void setHistory(const Series &series, double scale);
    /// Draws those of \a live that are later than everything drawn; of more than a feed keeps, the oldest go.
    void append(const QList<SeriesBucket> &live);

    /// Of everything that is drawn within \a keys; empty: nothing is.
    std::optional<QCPRange> valueRange(const QCPRange &keys) const;

    QCPGraph *line() const { return m_line; }

private:
    struct Points;
    static void breakAt(Points &points, double key);
    void draw(const Points &points, bool hasBand);
    void forgetOldest();
    void forgetExtremes();

    QCPGraph *m_lowest;
    QCPGraph *m_highest;
    QCPGraph *m_line;
    QCPGraph *m_dots;
    double m_scale = 1;
    bool m_hasBand = false;
    qsizetype m_fromHistory = 0; ///< points of the line
    UtcTime m_end; ///< of what is drawn
    mutable LineExtremes m_lineExtremes;
    mutable LineExtremes m_lowestExtremes;
    mutable LineExtremes m_highestExtremes;
};

} // namespace gorizont
