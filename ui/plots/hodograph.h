#pragma once

#include "core/values/series.h"

#include <QList>
#include <QPointF>

namespace gorizont {

/// One place on the way of a sensor's axis.
struct HodographPoint
{
    UtcTime time;
    QPointF place; ///< arc-seconds
    bool isJoined = false; ///< to the point before it: no gap lies between
    bool operator==(const HodographPoint &) const = default;
};

/// The moments at which both series have a valid value, in ascending time. Pure.
QList<HodographPoint> hodograph(const Series &x, const Series &y);

} // namespace gorizont
