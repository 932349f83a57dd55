#pragma once

#include "ui/plots/cursorlines.h"
#include "ui/plots/plottime.h"

namespace gorizont {

class TimePlot;

/// The cursors of a plot over time. GUI thread.
class CursorPair : public CursorLines
{
    Q_OBJECT

public:
    explicit CursorPair(TimePlot *plot);

    UtcTime first() const { return toTime(firstKey()); } ///< A
    UtcTime second() const { return toTime(secondKey()); } ///< B
    void place(UtcTime first, UtcTime second) { placeAt(toKey(first), toKey(second)); }
};

} // namespace gorizont
