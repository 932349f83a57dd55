#pragma once

#include "core/devices/simulateddevice.h"
#include "core/simulation/faultplan.h"
#include "core/values/lineconfig.h"

#include <QRandomGenerator>

#include <memory>
#include <vector>

namespace gorizont {

/// The other end of one line: the devices that the ini lists on it, the time their bytes take, and what goes wrong.
/// Time is given, nothing waits.
class SimulatedBus
{
public:
    using Time = SimulatedDevice::Time;

    struct Piece
    {
        QByteArray bytes;
        Time at; ///< when the last of these bytes has arrived at the host
    };

    struct Options
    {
        quint64 seed = 1;
        FaultPlan faults;
        Time responseDelay = std::chrono::milliseconds(1); ///< between the end of a request and the start of its answer
    };

    SimulatedBus(const LineConfig &line, const Options &options);

    const PortSettings &port() const { return m_port; }
    /// The host goes on with another speed and frame.
    void setPort(const PortSettings &port);

    /// How long \a bytes take at the speed and frame of the line.
    Time wireTime(qsizetype bytes) const { return bytes * m_byteTime; }

    /// The host starts to send \a bytes at \a now; returns what comes back, in order of time.
    QList<Piece> receive(QByteArrayView bytes, Time now);

    const std::vector<std::unique_ptr<SimulatedDevice>> &devices() const { return m_devices; }

private:
    void strikeOnce(Time now);
    bool isSilent(int number, Time now) const;
    bool happens(SimulatedFault::Kind kind, Time now);
    void append(QList<Piece> &pieces, const QByteArray &answer, Time start, Time now);
    void appendEven(QList<Piece> &pieces, const QByteArray &bytes, Time start) const;

    Options m_options;
    PortSettings m_port;
    int m_dataBits;
    Time m_byteTime{0};
    std::vector<std::unique_ptr<SimulatedDevice>> m_devices;
    std::vector<bool> m_isStruck; ///< which of the faults that happen once have happened
    QRandomGenerator m_random;
};

} // namespace gorizont
