#include "ui/plots/cursorpair.h"

#include "ui/plots/timeplot.h"

namespace gorizont {

CursorPair::CursorPair(TimePlot *plot)
    : CursorLines(plot)
{
}

} // namespace gorizont
