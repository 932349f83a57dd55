#pragma once

#include "core/values/sensortype.h"

#include <QHash>
#include <QString>

namespace gorizont {

/// One sensor as the ini describes it (manual 000, section 5). `{i}` is its index within the port.
struct SensorConfig
{
    int port = 0; ///< number of its section [Port{port}], 1…16
    int index = 0; ///< {i}, 1…
    int number = 0; ///< N{i}: site-wide number, unique, 1…
    int address = 1; ///< adr{i}: address on the line, 1…255
    bool isOn = false;

    SensorType type = SensorType::None;
    QString model; ///< `IN-D3`, `AN-D3`, …
    QString name; ///< Name{i}, with its keywords
    QString place; ///< Place{i}
    QString serialNumber; ///< SND3{i}: of the primary transducer
    QString installedOn; ///< SetData{i}
    QString adjustedOn; ///< AdjData{i}
    QString note; ///< Note{i}

    bool measuresTilt = false;
    bool measuresTemperature = false;
    bool measuresAcceleration = false;
    bool measuresWeather = false; ///< wind and what else a weather station has
    bool hasThermostat = false; ///< fan and heater count in the status word
    bool isInChain = false; ///< a [Chain{k}] makes displacements of its tilt

    double offsetX = 0; ///< Xo{i}, arc-seconds
    double offsetY = 0; ///< Yo{i}, arc-seconds
    double offsetT = 0; ///< To{i}, °C
    bool isYInverted = false; ///< InvY{i}
    double rotationX = 0; ///< RotX{i}, degrees

    /// Keys of this sensor that only its driver understands (`protocol`, `verifycrc`, …): lower case, without {i}.
    QHash<QString, QString> options;

    bool operator==(const SensorConfig &) const = default;
};

} // namespace gorizont
