#pragma once

#include "core/values/series.h"
#include "ui/plots/plotting.h"

namespace gorizont {

/// A plot over time: moved and zoomed by wheel, drag and keys, its values scaled so that all of them are seen unless
/// somebody scaled them by hand. GUI thread.
///
/// The wheel zooms time, over a scale of values that scale, with Shift it moves. Dragging moves time, over a scale that
/// scale; a double click lets all scales fit again. Keys: ← → PgUp PgDn move, + − zoom, Home and End.
class TimePlot : public QCustomPlot
{
    Q_OBJECT

public:
    explicit TimePlot(QWidget *parent = nullptr);

    TimeSpan span() const;
    void setSpan(const TimeSpan &span);
    int plotWidth() const; ///< of the span, pixels

    /// Zooming keeps the right end in its place, instead of what is under the mouse.
    void setKeepsEnd(bool keepsEnd) { m_keepsEnd = keepsEnd; }

    /// Zooms about the middle or the end; \a factor > 1 shows more time.
    void zoom(double factor);
    /// Moves by a share of the span, positive: to later times.
    void move(double share);

    bool isScaledByHand(const QCPAxis *axis) const { return m_byHand.contains(axis); }
    void letScalesFit();

Q_SIGNALS:
    void spanChanged();
    /// It was the user who moved or zoomed.
    void movedByHand();
    void beginningWanted(); ///< Home
    void endWanted(); ///< End
    void fitWanted(); ///< the scales may be computed anew

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

    void forgetScales() { m_byHand.clear(); }

private:
    void showKeys(double lower, double upper);
    void zoomAbout(double factor, double key);
    void scaleByHand(QCPAxis *axis, const QCPRange &range);
    QCPAxis *valueAxisAt(const QPointF &position) const;

    struct Drag
    {
        QPointF start;
        QCPAxis *axis = nullptr; ///< of values; null: time is dragged
        QCPRange range;
    };
    std::optional<Drag> m_drag;
    QSet<const QCPAxis *> m_byHand;
    bool m_keepsEnd = false;
};

} // namespace gorizont
