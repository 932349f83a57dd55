#pragma once

#include <QActionGroup>

#include <chrono>

namespace gorizont {

/// The spans of time that a click shows, 10 minutes … a year; the one that is shown is checked. GUI thread.
class RangeActions : public QActionGroup
{
    Q_OBJECT

public:
    /// Spans that are longer than \a longest are left out.
    explicit RangeActions(QObject *parent, std::chrono::seconds longest = std::chrono::years(1));

    /// Checks the action of \a span, or none.
    void setShown(std::chrono::microseconds span);

Q_SIGNALS:
    void chosen(std::chrono::seconds span);
};

} // namespace gorizont
