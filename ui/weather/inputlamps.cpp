#include "ui/weather/inputlamps.h"

#include "ui/models/colours.h"
#include "ui/models/weathertext.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace gorizont {

namespace {

constexpr int lampsInRow = 16;
constexpr int rows = InputLamps::count / lampsInRow;
constexpr int lampSize = 12; ///< pixels
constexpr int space = 3;

} // namespace

InputLamps::InputLamps(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("inputLamps"));
    setAccessibleName(tr("Digital inputs"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setInputs({});
}

void InputLamps::setInputs(std::optional<quint32> word)
{
    if (word == m_word && !accessibleDescription().isEmpty()) {
        return;
    }
    m_word = word;
    setAccessibleDescription(word ? weathertext::digital(*word) : tr("not known"));
    update();
}

/// The number below its lamp.
QSize InputLamps::cellSize() const
{
    const int number = fontMetrics().horizontalAdvance(QStringLiteral("00"));
    return {std::max(number, lampSize) + 2 * space, lampSize + fontMetrics().height() + space};
}

QSize InputLamps::sizeHint() const
{
    return {lampsInRow * cellSize().width(), rows * cellSize().height()};
}

QRect InputLamps::lampRect(int input) const
{
    const QSize cell = cellSize();
    return {QPoint(input % lampsInRow * cell.width(), input / lampsInRow * cell.height()), cell};
}

int InputLamps::lampAt(QPoint place) const
{
    for (int input = 0; input < count; ++input) {
        if (lampRect(input).contains(place)) {
            return input;
        }
    }
    return -1;
}

QString InputLamps::stateText(int input) const
{
    if (!m_word) {
        return tr("Input %1: not known").arg(input);
    }
    return *m_word >> input & 1U ? tr("Input %1: on").arg(input) : tr("Input %1: off").arg(input);
}

bool InputLamps::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const int input = lampAt(help->pos());
        QToolTip::showText(help->globalPos(), input < 0 ? QString() : stateText(input), this);
        return true;
    }
    return QWidget::event(event);
}

void InputLamps::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int input = 0; input < count; ++input) {
        paintLamp(painter, input);
    }
}

void InputLamps::paintLamp(QPainter &painter, int input) const
{
    const QRect cell = lampRect(input);
    const QColor on = palette().color(QPalette::WindowText);
    const QColor off = colours::mutedText(palette());
    const bool isOn = m_word && (*m_word >> input & 1U);
    const QPointF centre(cell.center().x() + 0.5, cell.top() + lampSize / 2.0 + 1);
    if (isOn) {
        painter.setPen(QPen(on, 1.2));
        painter.setBrush(palette().color(QPalette::Highlight));
        painter.drawEllipse(centre, lampSize / 2.0 - 1, lampSize / 2.0 - 1);
    } else if (m_word) {
        painter.setPen(QPen(off, 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, lampSize / 2.0 - 2.5, lampSize / 2.0 - 2.5);
    } else {
        painter.setPen(Qt::NoPen);
        painter.setBrush(off);
        painter.drawEllipse(centre, 1.2, 1.2);
    }
    painter.setPen(isOn ? on : off);
    QFont number = font();
    number.setBold(isOn);
    painter.setFont(number);
    painter.drawText(cell.adjusted(0, lampSize, 0, 0), Qt::AlignHCenter | Qt::AlignTop, QString::number(input));
}

} // namespace gorizont
