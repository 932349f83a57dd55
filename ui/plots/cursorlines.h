#pragma once

#include <QObject>
#include <QPointer>

#include <array>

class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;

namespace gorizont {

/// Two upright lines over a plot, A and B, that are dragged with the mouse; Ctrl moves A and Shift moves B by a pixel with
/// the arrow keys. GUI thread.
class CursorLines : public QObject
{
    Q_OBJECT

public:
    explicit CursorLines(QCustomPlot *plot);

    /// Where they are out of sight, they appear at the thirds of what is seen.
    void setShown(bool isShown);
    bool isShown() const { return m_isShown; }

    double firstKey() const { return m_keys[0]; } ///< A
    double secondKey() const { return m_keys[1]; } ///< B
    void placeAt(double first, double second);

Q_SIGNALS:
    void moved();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void draw();
    bool press(const QPointF &position);
    bool moveByKey(int key, Qt::KeyboardModifiers modifiers);

    QCustomPlot *m_plot;
    std::array<QPointer<QCPItemStraightLine>, 2> m_lines; ///< of the plot
    std::array<QPointer<QCPItemText>, 2> m_labels;
    std::array<double, 2> m_keys{};
    int m_dragged = -1; ///< −1: none
    bool m_isShown = false;
    bool m_isPlaced = false; ///< somebody said where they are
};

} // namespace gorizont
