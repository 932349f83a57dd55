#pragma once

#include "core/station/stationcomplaint.h"
#include "core/values/lineconfig.h"

#include <QByteArray>

#include <chrono>

namespace gorizont::station {

/// What stands behind a line of ACK.INI: the type letter of its port (manual 004, section 3.1).
enum class ObjectKind : quint8 {
    Gathering, ///< x: gathers all others
    L154, ///< w: a source of raw values, described by ACK.LCD
    Fastwel, ///< a: a source of raw values, described by ACK.FWL
    Wind, ///< v: pulses of speed on CTS and of direction on DSR
    Line, ///< q: the protocol of sections 3.6 and 4: to a dispatcher, or to another АКП
};

/// A line of ACK.INI. The port field is the type letter and a number (`q1`: COM1), or, beyond the manual, the letter, a colon and
/// a device: `q:/dev/ttyS1`, `q:tcp://192.168.1.30:4001`, `w:file:record.csv`.
struct StationObject
{
    int number = 1; ///< of the object, 1…255; several lines may have the same
    std::chrono::seconds period{0}; ///< of the records in the database; 0: none
    ObjectKind kind = ObjectKind::Gathering;
    int com = 0; ///< n of COMn, 1…; 0: none is given
    QString device; ///< behind the colon; empty: com decides
    int baudRate = 9600; ///< baud
    int dataBits = 8; ///< 5…8
    StopBits stopBits = StopBits::One;
    Parity parity = Parity::None;
    QString extra; ///< as written; empty: none
    int windMultiplier = 100; ///< v: 1…1000, from `extra`
    int line = 0; ///< of ACK.INI, 1…

    /// A `q` line with the station's own number: a dispatcher asks there. With another number: that АКП is polled there.
    bool isDispatcher(int stationNumber) const { return kind == ObjectKind::Line && number == stationNumber; }
    bool isPolled(int stationNumber) const { return kind == ObjectKind::Line && number != stationNumber; }
    bool operator==(const StationObject &) const = default;
};

/// ACK.INI: the lines that are good, in their order. The types r, y and g are refused: their formats are documented nowhere.
QList<StationObject> readObjects(const QString &file, const QByteArray &bytes, Complaints &complaints);

} // namespace gorizont::station
