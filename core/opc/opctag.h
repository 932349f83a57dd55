#pragma once

#include "core/opc/opcvalue.h"
#include "core/values/reading.h"

#include <QStringList>

#include <functional>

namespace gorizont {

enum class OpcType : quint8 { Bool, Double };

/// What one field of an answer says by itself, whatever the state of sensor and line. No value and Good: the answer does not
/// hold the field.
struct OpcFieldValue
{
    OpcValue value;
    OpcQuality quality = OpcQuality::Good;
};

/// One field of a sensor below its branch.
struct OpcField
{
    QString path; ///< `DATA.Angl_X`
    QString alias; ///< `DATA.Amax_X`, the path by table 11.1 of manual 000; empty: the same, or none
    QString description; ///< with the unit, in the language of the program
    OpcType type = OpcType::Double;
    std::function<OpcFieldValue(const Reading &)> read;
};

/// One element of the address space.
struct OpcTag
{
    QString name; ///< `[COM5].Sensor_001[AND3][Addr:002].DATA.Angl_X`; a dot inside brackets parts nothing
    QStringList aliases; ///< other names of the same
    QString description;
    OpcType type = OpcType::Double;
    int number = 0; ///< N of its sensor
    std::function<OpcFieldValue(const Reading &)> read;
};

} // namespace gorizont
