#pragma once

#include "core/devices/and3/and3service.h"

#include <QJsonObject>

/// How the settings and values of an АН-Д3 are written.
namespace gorizont::tool {

void insertValues(QJsonObject &object, const and3::ComplexRead &read);
void insertSettings(QJsonObject &object, const and3::Settings &settings);
QString textOf(const and3::Settings &settings); ///< a line each
QString lineOf(const and3::Settings &settings); ///< what a scan shows
QString lineOf(const and3::ComplexRead &values); ///< one reading

} // namespace gorizont::tool
