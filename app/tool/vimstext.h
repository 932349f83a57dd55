#pragma once

#include "core/devices/lvims/lvimsservice.h"
#include "core/values/vibrationjson.h"

/// What the commands of L-VIMS print, as text and as JSON.
namespace gorizont::tool {

QString textOf(const lvims::Identity &identity);
QString textOf(const Vibration &vibration);
QString textOf(const lvims::Capture &capture, lvims::Capture::Kind kind);
/// Why settings were not taken.
QString textOf(const lvims::SettingErrors &errors, Fault fault);

void insertCapture(QJsonObject &object, const lvims::Capture &capture, lvims::Capture::Kind kind);

} // namespace gorizont::tool
