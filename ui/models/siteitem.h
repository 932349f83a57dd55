#pragma once

#include <QMetaType>

namespace gorizont {

/// One element of the site: the server, one of its lines or one of its sensors.
struct SiteItem
{
    enum class Kind : quint8 { Server, Line, Sensor };

    Kind kind = Kind::Server;
    int index = 0; ///< into SensorRegistry::lines() or sensors(); 0 for the server

    static SiteItem server() { return {}; }
    static SiteItem line(int index) { return {Kind::Line, index}; }
    static SiteItem sensor(int index) { return {Kind::Sensor, index}; }

    bool operator==(const SiteItem &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::SiteItem)
