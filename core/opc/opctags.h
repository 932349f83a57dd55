#pragma once

#include "core/config/serverconfig.h"
#include "core/opc/opctag.h"

#include <QHash>

namespace gorizont {

/// What the tags of weather stations are made of beside the ini: N → parameters. A station that is not in it has those of
/// weatherParameters().
using OpcWeather = QHash<int, QList<WeatherParameter>>;

/// The address space of the configuration (manual 000, section 11; spec/opc.md): line by line, sensor by sensor, in the order
/// of the ini; switched-off ones are listed too, so that a list that was registered lasts. Names are unique. Pure.
QList<OpcTag> opcTags(const QList<LineConfig> &lines, const OpcWeather &weather = {});

/// `[COM5].Sensor_001[AND3][Addr:002]`
QString opcBranch(const LineConfig &line, const SensorConfig &sensor);

QString opcTypeName(OpcType type); ///< `bool`, `double`

/// 64 hex digits: SHA-256 over `name TAB type LF` of all tags in their order.
QByteArray opcTagsHash(const QList<OpcTag> &tags);

/// The list for those who set up a SCADA system: name, type and description, parted by tabs, a line each, UTF-8.
QByteArray opcTagList(const QList<OpcTag> &tags);

} // namespace gorizont
