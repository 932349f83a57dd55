#pragma once

#include "ui/plots/hodograph.h"
#include "ui/plots/plottext.h"
#include "ui/plots/spanpage.h"

#include <QRectF>

class QCPColorScale;
class QCPCurve;
class QCPItemText;
class QCPItemTracer;
class QCustomPlot;

namespace gorizont {

/// The page <Годограф>: the way of a sensor's axis over a span, its colour telling the time, both scales equal, its first and
/// last place marked. GUI thread.
class XyPage : public SpanPage
{
    Q_OBJECT

public:
    XyPage(SensorRegistry &registry, SeriesSource source, QWidget *parent = nullptr, SeriesFeed::Clock clock = utcNow);

protected:
    void draw() override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Mark
    {
        QCPItemTracer *point = nullptr;
        QCPItemText *name = nullptr;
    };
    Mark addMark(const QString &name, bool isStart);
    void dress();
    void place(const Mark &mark, const QList<HodographPoint> &points, qsizetype at);
    void buildPlot();
    void drawWay(const QList<HodographPoint> &points);
    void scaleEqually();
    QPointF drawn(const QPointF &place) const;

    QCustomPlot *m_plot;
    QCPColorScale *m_times = nullptr;
    QList<QCPCurve *> m_parts; ///< one colour each, ascending in time
    Mark m_start;
    Mark m_end;
    QRectF m_bounds; ///< of what is drawn
    TiltUnit m_unit = TiltUnit::ArcSeconds;
};

} // namespace gorizont
