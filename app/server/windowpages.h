#pragma once

#include <QString>

#include <functional>

namespace gorizont {

class ArchiveReader;
class LineWorker;
class MainWindow;
class SensorRegistry;
struct ServerConfig;

/// What the pages of the window beside the tabs of the manual show.
struct PageSources
{
    SensorRegistry &registry;
    ArchiveReader &archive;
    const ServerConfig &config;
    QString dataFolder;
    std::function<LineWorker *(int port)> worker; ///< of section [Port{port}]; null when that port is off
};

/// Adds <Графики> and <История>; <Годограф> where sensors measure tilt, <Колебания> where they measure acceleration,
/// <Вибрация> where there is an L-VIMS, <Перемещения> where the site has chains, and <Погода> where it has a weather station.
/// F5 asks the archive again, and reads the files of stations that run in this program. All sources outlive the window.
void addWindowPages(MainWindow &window, const PageSources &sources);

} // namespace gorizont
