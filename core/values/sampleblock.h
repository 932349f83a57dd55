#pragma once

#include "core/values/timing.h"

#include <QList>
#include <QMetaType>

namespace gorizont {

/// Consecutive raw samples of both axes of an accelerometer, in the axes of the device.
struct SampleBlock
{
    int number = 0; ///< N, the sensor
    UtcTime start; ///< of the first sample
    double rate = 10; ///< samples a second
    double scale = 1; ///< mm/s² of one raw unit, with its sign
    bool followsPrevious = false; ///< no sample is missing between the previous block and this one
    QList<qint16> x; ///< raw units; АН-Д3: 1/8 arc-second
    QList<qint16> y; ///< as many as x

    bool operator==(const SampleBlock &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::SampleBlock)
