#pragma once

#include "core/values/vibration.h"

#include <QJsonObject>

namespace gorizont {

/// Adds `channels`: `channel` (0…3), `state` (CH_STATUS: 0 good, 1 short circuit, 2 break, 65535 no data), `measurements`:
/// `index` (0…7), `type` (MEAS_TYPE), `value`, `percent`, `fault`, `warning`, `stop`, `baselineValid`, `baselineExceeded`; and
/// `relays`: `index` (0…7), `logical`, `physical`, `error`, `enabled`. null: not valid, or the module does not know.
void insertVibration(QJsonObject &object, const Vibration &vibration);

} // namespace gorizont
