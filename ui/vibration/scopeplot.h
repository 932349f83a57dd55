#pragma once

#include "ui/plots/plotting.h"

namespace gorizont {

/// A plot whose horizontal axis has a whole: moved and zoomed within it by wheel, drag and keys, its values scaled to what is
/// seen. GUI thread.
///
/// The wheel zooms, with Shift it moves; dragging moves; a double click and Home show the whole. Keys: ← → PgUp PgDn move, + − ↑ ↓ zoom.
class ScopePlot : public QCustomPlot
{
    Q_OBJECT

public:
    explicit ScopePlot(QWidget *parent = nullptr);

    /// What there is to see; shown whole if it is another one than before.
    void setWhole(const QCPRange &whole);
    void showWhole();
    void showRange(const QCPRange &range);
    /// The values of all curves that are seen fit in, from 0 if \a fromZero.
    void setFromZero(bool fromZero) { m_fromZero = fromZero; }
    void fit();

Q_SIGNALS:
    void rangeSeen();

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void zoom(double factor, double about);
    void move(double share);

    struct Drag
    {
        double start = 0; ///< pixel
        QCPRange range;
    };
    std::optional<Drag> m_drag;
    QCPRange m_whole{0, 1};
    bool m_fromZero = false;
};

} // namespace gorizont
