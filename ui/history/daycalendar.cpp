// How the calendar behaves; how it looks stands in daycalendarpaint.cpp.

#include "ui/history/daycalendar.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>

namespace gorizont {

namespace {

QDate beginOfMonth(QDate day)
{
    return {day.year(), day.month(), 1};
}

} // namespace

DayCalendar::DayCalendar(QWidget *parent)
    : QWidget(parent)
    , m_today(QDate::currentDate())
    , m_month(beginOfMonth(m_today))
    , m_current(m_today)
    , m_anchor(m_today)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Days by completeness"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void DayCalendar::setMarks(const DayMarks &marks)
{
    m_marks = marks;
    update();
}

void DayCalendar::setToday(QDate today)
{
    const QDate before = std::exchange(m_today, today);
    if (today == before) {
        return;
    }
    const bool wasLast = beginOfMonth(lastShown()) == beginOfMonth(before);
    if (m_current == before && m_anchor == before) {
        go(today, false);
    }
    if (wasLast) {
        showMonth(today);
    }
    update();
}

void DayCalendar::choose(QDate first, QDate last)
{
    m_anchor = first;
    go(last, true);
}

void DayCalendar::showEarlier()
{
    showMonth(m_month.addMonths(-1));
}

void DayCalendar::showLater()
{
    showMonth(m_month.addMonths(1));
}

/// The month of today is the last that is shown.
void DayCalendar::showMonth(QDate month)
{
    m_month = std::min(beginOfMonth(month), beginOfMonth(m_today).addMonths(1 - monthCount()));
    update();
    const std::pair days(firstShown(), lastShown());
    if (days != m_told) {
        m_told = days;
        Q_EMIT shown(days.first, days.second);
    }
}

void DayCalendar::go(QDate day, bool isExtending)
{
    m_current = std::min(day, m_today);
    m_anchor = isExtending ? std::min(m_anchor, m_today) : m_current;
    if (m_current < firstShown()) {
        showMonth(m_current);
    } else if (m_current > lastShown()) {
        showMonth(beginOfMonth(m_current).addMonths(1 - monthCount()));
    }
    update();
    tellChoice();
}

void DayCalendar::tellChoice()
{
    const DayMark mark = m_marks.value(m_current);
    setAccessibleDescription(
        mark.toolTip.isEmpty() ? calendarLocale().toString(m_current, QLocale::LongFormat) : mark.toolTip);
    Q_EMIT chosen(firstChosen(), lastChosen());
}

void DayCalendar::keyPressEvent(QKeyEvent *event)
{
    const bool isExtending = event->modifiers().testFlag(Qt::ShiftModifier);
    switch (event->key()) {
    case Qt::Key_Left: return go(m_current.addDays(-1), isExtending);
    case Qt::Key_Right: return go(m_current.addDays(1), isExtending);
    case Qt::Key_Up: return go(m_current.addDays(-7), isExtending);
    case Qt::Key_Down: return go(m_current.addDays(7), isExtending);
    case Qt::Key_PageUp: return go(m_current.addMonths(-1), isExtending);
    case Qt::Key_PageDown: return go(m_current.addMonths(1), isExtending);
    case Qt::Key_Home: return go(beginOfMonth(m_current), isExtending);
    case Qt::Key_End: return go(beginOfMonth(m_current).addMonths(1).addDays(-1), isExtending);
    default: QWidget::keyPressEvent(event);
    }
}

void DayCalendar::mousePressEvent(QMouseEvent *event)
{
    const QDate day = dayAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && day.isValid() && day <= m_today) {
        go(day, event->modifiers().testFlag(Qt::ShiftModifier));
    }
}

void DayCalendar::mouseMoveEvent(QMouseEvent *event)
{
    const QDate day = dayAt(event->position().toPoint());
    if (event->buttons().testFlag(Qt::LeftButton) && day.isValid() && day <= m_today && day != m_current) {
        go(day, true);
    }
}

/// A touch pad tells of a step in many small parts.
void DayCalendar::wheelEvent(QWheelEvent *event)
{
    const int delta = event->angleDelta().y();
    if (delta == 0) {
        event->ignore();
        return;
    }
    const bool isBack = m_wheel != 0 && (m_wheel > 0) != (delta > 0);
    m_wheel = isBack ? delta : m_wheel + delta;
    for (; m_wheel >= QWheelEvent::DefaultDeltasPerStep; m_wheel -= QWheelEvent::DefaultDeltasPerStep) {
        showEarlier();
    }
    for (; m_wheel <= -QWheelEvent::DefaultDeltasPerStep; m_wheel += QWheelEvent::DefaultDeltasPerStep) {
        showLater();
    }
    event->accept();
}

/// As many months as fit, the last of them as before.
void DayCalendar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const QDate last = m_told.second.isValid() ? m_told.second : m_today;
    showMonth(beginOfMonth(last).addMonths(1 - monthCount()));
}

void DayCalendar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        updateGeometry();
    }
}

bool DayCalendar::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto *help = static_cast<QHelpEvent *>(event);
    const QDate day = dayAt(help->pos());
    if (!day.isValid() || day > m_today) {
        QToolTip::hideText();
        return true;
    }
    const DayMark mark = m_marks.value(day);
    const QString nothing =
        calendarLocale().toString(day, QLocale::LongFormat) + u'\n' + tr("nothing is known of this day");
    QToolTip::showText(help->globalPos(), mark.isKnown() ? mark.toolTip : nothing, this, dayRect(day));
    return true;
}

} // namespace gorizont
