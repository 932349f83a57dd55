#pragma once

#include "core/values/series.h"

#include <QString>

namespace gorizont {

class MainWindow;
class SensorRegistry;

/// What the pages of the window beside the tabs of the manual are fed from.
struct PageSources
{
    SeriesSource series; ///< null: nothing is archived
    QString dataFolder;
};

/// Adds <Графики>, and <Перемещения> where the site has chains. The registry outlives the window.
void addWindowPages(MainWindow &window, SensorRegistry &registry, const PageSources &sources);

} // namespace gorizont
