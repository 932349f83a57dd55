#pragma once

#include "core/values/sensorconfig.h"
#include "tests/support/fakeline.h"

#include <QStringList>

namespace gorizont::test {

/// A recording of a conversation with a sensor and what the driver must make of it, as text, one item a line:
///
///     # comment
///     @ name ИН-Д3 (IN-D3)       the sensor: name (its keywords decide the type), address, number, any driver option
///     @ address 1
///     > 7E 9B 01 01 9B 7E        what the driver must send
///     < 7E 9B 01 01 6A 77        what arrives; further lines are further pieces
///     < 80 38 C2 00 FC 7E
///     = tiltX 194.219            what the poll must give
///
/// The exchanges up to and with a block of `=` lines are one group, and a group is one poll:
///
///     = tiltX, tiltY, temperature, heaterPower, fanFrequency NUMBER   equal to the last digit written; `none`: absent
///     = rawStatus, rawMode NUMBER                                     decimal, or hexadecimal with 0x
///     = channelI STATE, measurementI.M TYPE NUMBER                    of a vibration module; `off`, `none`: not in use
///     = conditions NAME…                                              all that are set; `none`
///     = parameters N                                                  of a weather station; `none`: no weather at all
///     = T1.mean NUMBER                                                of its parameter T1: mean, instant, min, max,
///                                                                     voltage, voltageInstant, maxPeriod, deviation
///     = digital 0xN                                                   its digital inputs
///     = events N…                                                     seconds, < 0 an end, newest first; `none`
///     = fault NAME                                                    Timeout, Checksum, …; Closed: the line vanishes
///     = blocks N                                                      the blocks of one fetch; in a group with other
///                                                                     expectations after the poll, alone instead of it
struct Talk
{
    struct Expectation
    {
        QString key;
        QString value;
        int line = 0; ///< of the file, 1…
    };
    struct Exchange
    {
        QByteArray request;
        QList<FakeLine::Piece> pieces;
    };
    struct Group
    {
        QList<Exchange> exchanges;
        QList<Expectation> expectations;
    };

    SensorConfig sensor;
    QList<Group> groups;
    QStringList mistakes; ///< lines that are not in this format
};

Talk parseTalk(const QByteArray &text);

/// Plays the recording to the driver of its sensor. Returns what was not as expected, a sentence each; empty: all was.
QStringList playTalk(const Talk &talk);

} // namespace gorizont::test
