#pragma once

#include <QWidget>

#include <optional>

namespace gorizont {

/// The 32 digital inputs of a station as numbered lamps: a full disc is on, a ring is off, a dot is not known. GUI thread.
class InputLamps : public QWidget
{
    Q_OBJECT

public:
    static constexpr int count = 32;

    explicit InputLamps(QWidget *parent = nullptr);

    void setInputs(std::optional<quint32> word);
    std::optional<quint32> inputs() const { return m_word; }

    int lampAt(QPoint place) const; ///< −1: none
    QRect lampRect(int input) const; ///< of lamp and number

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;

private:
    QSize cellSize() const;
    void paintLamp(QPainter &painter, int input) const;
    QString stateText(int input) const;

    std::optional<quint32> m_word;
};

} // namespace gorizont
