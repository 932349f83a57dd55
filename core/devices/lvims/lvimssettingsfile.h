#pragma once

#include "core/devices/lvims/lvimsprotocol.h"

#include <QJsonObject>

#include <optional>

/// All settings of a module as a file. Pure.
namespace gorizont::lvims {

/// LAST_WR_ERROR and LAST_CHECK_SETTINGS_ERR; 0: none.
using SettingErrors = std::pair<quint16, quint32>;

/// Adds `name`, `serial`, `firmware`, `board`, `mode`, `writeError`, `settingsError`.
void insertIdentity(QJsonObject &object, const Identity &identity);
/// Adds `writeError` and `settingsError`.
void insertErrors(QJsonObject &object, const SettingErrors &errors);

/// JSON: what the module is, and `registers`, all of SET in the order of their addresses.
QByteArray settingsFile(const Identity &identity, const QList<quint16> &image);
/// Empty: \a bytes are no such file.
std::optional<QList<quint16>> settingsIn(const QByteArray &bytes);

} // namespace gorizont::lvims
