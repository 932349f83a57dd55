#pragma once

#include "core/devices/lvims/lvimsservice.h"

namespace gorizont {

/// Sentences of the service window of L-VIMS. Pure.
namespace vimstext {

QString mode(int mode); ///< DEVMODE: `2, at work`
QString error(quint32 code); ///< `0, none`, or the code, decimal and hexadecimal
/// `LAST_WR_ERROR 2, LAST_CHECK_SETTINGS_ERR 0`
QString errors(const lvims::SettingErrors &errors);

/// A line for each of the first ones: `WF_ACQ_TIME: 500 → 1000`.
QString differences(const QList<lvims::SettingDifference> &differences);
bool touchesNetwork(const QList<lvims::SettingDifference> &differences);
/// That the connection will be lost when \a wanted, all settings of a module, is used, and what is to be done.
QString networkWarning(const QList<quint16> &wanted, int port);

} // namespace vimstext

} // namespace gorizont
