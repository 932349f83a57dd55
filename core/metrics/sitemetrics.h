#pragma once

#include "core/metrics/exposition.h"
#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"

#include <QHash>

namespace gorizont {

/// What is known of a site at one moment.
struct SiteSnapshot
{
    QList<LineConfig> lines; ///< with their sensors
    QHash<int, Reading> readings; ///< N → the last one
    QHash<int, LineStatus> statuses; ///< section → the last one
    SteadyTime now;
    SteadyTime started; ///< the program
};

/// Ports and sensors as metrics, in the order of the ini. Ports carry `port` (`COM4`) and `index` (of the section, which
/// is unique), sensors `port`, `sensor` (N) and `type`. A value that is not valid now is left out. Pure.
MetricFamilies siteMetrics(const SiteSnapshot &site);

} // namespace gorizont
