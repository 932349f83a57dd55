#pragma once

#include "core/devices/usmisn/usmisnservice.h"

#include <QJsonObject>

/// How what an УСМ-ИСН says is written.
namespace gorizont::tool {

void insertIdentity(QJsonObject &object, const usmisn::Identity &identity);
void insertValue(QJsonObject &object, const usmisn::Value &value);
QString textOf(const usmisn::Identity &identity); ///< a line each
QString lineOf(const usmisn::Identity &identity); ///< what a scan shows
QString lineOf(const usmisn::Value &value);
QString serialText(quint32 serial); ///< eight digits

} // namespace gorizont::tool
