#pragma once

#include "core/devices/lvims/lvimsservice.h"
#include "core/values/vibrationjson.h"

/// What the commands of L-VIMS print, as text and as JSON, and their file of settings.
namespace gorizont::tool {

QString textOf(const lvims::Identity &identity);
QString textOf(const Vibration &vibration);
QString textOf(const lvims::Capture &capture, lvims::Capture::Kind kind);
/// Why settings were not taken. \a errors: LAST_WR_ERROR, LAST_CHECK_SETTINGS_ERR.
QString textOf(const std::pair<quint16, quint32> &errors, Fault fault);

void insertIdentity(QJsonObject &object, const lvims::Identity &identity);
void insertCapture(QJsonObject &object, const lvims::Capture &capture, lvims::Capture::Kind kind);
void insertErrors(QJsonObject &object, const std::pair<quint16, quint32> &errors);

/// JSON: what the module is, and `registers`, all of SET in the order of their addresses.
QByteArray settingsFile(const lvims::Identity &identity, const QList<quint16> &values);
/// Empty: \a bytes are no such file.
std::optional<QList<quint16>> settingsIn(const QByteArray &bytes);

} // namespace gorizont::tool
