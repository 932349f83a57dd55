// How the calendar looks; how it behaves stands in daycalendar.cpp.

#include "ui/history/daycalendar.h"
#include "ui/models/colours.h"

#include <QPainter>

namespace gorizont {

namespace {

constexpr int daysOfWeek = 7;
constexpr int weeks = 6; ///< that a month may touch
constexpr int headings = 2; ///< rows: the month, the days of the week
constexpr int space = 14; ///< between months, pixels

int columnOf(QDate day)
{
    return (day.dayOfWeek() - int(calendarLocale().firstDayOfWeek()) + daysOfWeek) % daysOfWeek;
}

int rowOf(QDate day)
{
    return (columnOf(QDate(day.year(), day.month(), 1)) + day.day() - 1) / daysOfWeek;
}

} // namespace

/// A day has its number above its per cent.
QSize DayCalendar::cellSize() const
{
    const QFontMetrics metrics = fontMetrics();
    return {metrics.horizontalAdvance(QStringLiteral("100%")) + 8, 2 * metrics.height() + 8};
}

QSize DayCalendar::monthSize() const
{
    const QSize cell = cellSize();
    const int heading = fontMetrics().height() + 4;
    return {daysOfWeek * cell.width() + space, headings * heading + weeks * cell.height() + space / 2};
}

int DayCalendar::monthsAcross() const
{
    return std::max(1, (width() + space) / monthSize().width());
}

int DayCalendar::monthCount() const
{
    return monthsAcross() * std::max(1, (height() + space / 2) / monthSize().height());
}

QSize DayCalendar::sizeHint() const
{
    return {3 * monthSize().width() - space, monthSize().height()};
}

QSize DayCalendar::minimumSizeHint() const
{
    return {monthSize().width() - space, monthSize().height() - space / 2};
}

QRect DayCalendar::monthRect(int index) const
{
    const QSize month = monthSize();
    const int left = (index % monthsAcross()) * month.width();
    const int top = (index / monthsAcross()) * month.height();
    return {left, top, month.width() - space, month.height() - space / 2};
}

QRect DayCalendar::dayRect(QDate day) const
{
    const int index = (day.year() - m_month.year()) * 12 + day.month() - m_month.month();
    if (index < 0 || index >= monthCount()) {
        return {};
    }
    const QSize cell = cellSize();
    const QRect month = monthRect(index);
    const int heading = fontMetrics().height() + 4;
    return {
        month.left() + columnOf(day) * cell.width(), month.top() + headings * heading + rowOf(day) * cell.height(),
        cell.width(), cell.height()};
}

QDate DayCalendar::dayAt(QPoint place) const
{
    for (QDate day = firstShown(); day <= lastShown(); day = day.addDays(1)) {
        if (dayRect(day).contains(place)) {
            return day;
        }
    }
    return {};
}

void DayCalendar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    for (int index = 0; index < monthCount(); ++index) {
        paintMonth(painter, index);
    }
}

void DayCalendar::paintMonth(QPainter &painter, int index) const
{
    const QDate month = m_month.addMonths(index);
    const QRect place = monthRect(index);
    const int heading = fontMetrics().height() + 4;
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::Text));
    const QString name = calendarLocale().standaloneMonthName(month.month());
    painter.drawText(
        QRect(place.left(), place.top(), place.width(), heading), Qt::AlignCenter,
        name.left(1).toUpper() + name.mid(1) + u' ' + QString::number(month.year()));
    painter.setFont(font());
    painter.setPen(colours::mutedText(palette()));
    const int cell = cellSize().width();
    for (int column = 0; column < daysOfWeek; ++column) {
        const int day = (int(calendarLocale().firstDayOfWeek()) - 1 + column) % daysOfWeek + 1;
        painter.drawText(
            QRect(place.left() + column * cell, place.top() + heading, cell, heading), Qt::AlignCenter,
            calendarLocale().standaloneDayName(day, QLocale::ShortFormat));
    }
    for (QDate day = month; day.month() == month.month(); day = day.addDays(1)) {
        paintDay(painter, day);
    }
}

void DayCalendar::paintDay(QPainter &painter, QDate day) const
{
    const QRect cell = dayRect(day);
    const DayMark mark = m_marks.value(day);
    const bool isChosen = day >= firstChosen() && day <= lastChosen();
    if (const QColor colour = dayColour(mark, colours::isDark(palette())); colour.isValid()) {
        painter.fillRect(cell.adjusted(1, 1, -1, -1), colour);
    }
    painter.setPen(day > m_today ? colours::mutedText(palette()) : palette().color(QPalette::Text));
    const int line = fontMetrics().height();
    const QRect above(cell.left(), cell.center().y() - line, cell.width(), line);
    const QRect below(cell.left(), cell.center().y(), cell.width(), line);
    QFont number = font();
    number.setBold(day == m_today);
    painter.setFont(number);
    painter.drawText(above, Qt::AlignCenter, QString::number(day.day()));
    painter.setFont(font());
    if (mark.isKnown()) {
        painter.drawText(below, Qt::AlignCenter, percentText(mark) + u'%');
    }
    if (isChosen) {
        const bool isCurrent = day == m_current && hasFocus();
        painter.setPen(QPen(palette().color(QPalette::Highlight), isCurrent ? 3 : 2));
        painter.drawRect(cell.adjusted(2, 2, -2, -2));
    }
}

} // namespace gorizont
