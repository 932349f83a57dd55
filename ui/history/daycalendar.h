#pragma once

#include "ui/history/daymark.h"

#include <QWidget>

#include <algorithm>
#include <utility>

namespace gorizont {

/// Months side by side, every day with its colour and the per cent that are there. Days are chosen with the mouse or the
/// arrows, several with Shift; PgUp and PgDn go by months. It asks for the days it shows. GUI thread.
class DayCalendar : public QWidget
{
    Q_OBJECT

public:
    explicit DayCalendar(QWidget *parent = nullptr);

    /// Of the days that are shown; the others are forgotten.
    void setMarks(const DayMarks &marks);
    /// Days after it are shown, and cannot be chosen. Whoever looks at the former one goes on with it.
    void setToday(QDate today);
    void choose(QDate first, QDate last);

    QDate firstChosen() const { return std::min(m_current, m_anchor); }
    QDate lastChosen() const { return std::max(m_current, m_anchor); }
    QDate firstShown() const { return m_month; }
    QDate lastShown() const { return m_month.addMonths(monthCount()).addDays(-1); }

    QRect dayRect(QDate day) const; ///< empty: not shown
    QRect currentRect() const { return dayRect(m_current); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public Q_SLOTS:
    void showEarlier();
    void showLater();

Q_SIGNALS:
    void chosen(QDate first, QDate last);
    void shown(QDate first, QDate last); ///< other days than before

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QSize cellSize() const;
    QSize monthSize() const; ///< with the space beside it
    int monthsAcross() const;
    int monthCount() const; ///< that fit
    QRect monthRect(int index) const;
    QDate dayAt(QPoint place) const; ///< invalid: none
    void go(QDate day, bool isExtending);
    void showMonth(QDate month);
    void tellChoice();

    void paintMonth(QPainter &painter, int index) const;
    void paintDay(QPainter &painter, QDate day) const;

    DayMarks m_marks;
    QDate m_today;
    QDate m_month; ///< the first day of the first month that is shown
    std::pair<QDate, QDate> m_told; ///< the days that were said to be shown
    QDate m_current; ///< where the keys go on from
    QDate m_anchor; ///< the other end of the choice
    int m_wheel = 0; ///< turned since the last month, eighths of a degree
};

} // namespace gorizont
