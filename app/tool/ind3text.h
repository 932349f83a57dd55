#pragma once

#include "core/devices/ind3/ind3service.h"

#include <QJsonObject>

/// How the settings of an ИН-Д3 are written.
namespace gorizont::tool {

void insertSettings(QJsonObject &object, const ind3::Settings &settings, ind3::Dialect dialect);
QString textOf(const ind3::Settings &settings); ///< a line each
QString lineOf(const ind3::Settings &settings); ///< what a scan shows

} // namespace gorizont::tool
