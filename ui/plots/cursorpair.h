#pragma once

#include "core/values/timing.h"

#include <QObject>
#include <QPointer>

#include <array>

class QCPItemStraightLine;
class QCPItemText;

namespace gorizont {

class TimePlot;

/// Two upright lines over a plot, A and B, that are dragged with the mouse; Ctrl moves A and Shift moves B by a pixel with
/// the arrow keys. GUI thread.
class CursorPair : public QObject
{
    Q_OBJECT

public:
    explicit CursorPair(TimePlot *plot);

    /// Where they are out of sight, they appear at the thirds of what is seen.
    void setShown(bool isShown);
    bool isShown() const { return m_isShown; }

    UtcTime first() const { return m_times[0]; } ///< A
    UtcTime second() const { return m_times[1]; } ///< B
    void place(UtcTime first, UtcTime second);

Q_SIGNALS:
    void moved();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void draw();
    bool press(const QPointF &position);
    bool moveByKey(int key, Qt::KeyboardModifiers modifiers);

    TimePlot *m_plot;
    std::array<QPointer<QCPItemStraightLine>, 2> m_lines; ///< of the plot
    std::array<QPointer<QCPItemText>, 2> m_labels;
    std::array<UtcTime, 2> m_times;
    int m_dragged = -1; ///< −1: none
    bool m_isShown = false;
};

} // namespace gorizont
