#pragma once

#include "core/values/sensorconfig.h"

#include <QList>

namespace gorizont {

enum class Parity : quint8 { None, Even, Odd, Mark, Space };
enum class StopBits : quint8 { One, OneAndHalf, Two };

/// One port as the ini describes it (manual 000, section 5, [Port{index}]).
struct LineConfig
{
    int index = 0; ///< 1…16, the number of the section
    QString name; ///< Name: text about the adapter
    int com = 1; ///< Num: n of COMn
    QString device; ///< Device: a path, `COM4`, `tcp://host:port`, `sim:`; empty: com decides
    int baudRate = 115200; ///< baud
    int dataBits = 8; ///< 5…8
    Parity parity = Parity::None;
    StopBits stopBits = StopBits::One;
    bool isRs485 = false; ///< RS485: the driver of the adapter controls the direction
    bool isOn = false;
    QList<SensorConfig> sensors;

    /// The name in tables, in the tree and in the journal.
    QString title() const { return QStringLiteral("COM%1").arg(com); }

    bool operator==(const LineConfig &) const = default;
};

} // namespace gorizont
