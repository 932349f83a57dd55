#pragma once

#include "core/devices/buildingmotion.h"
#include "core/devices/simulateddevice.h"
#include "core/devices/usmisn/usmisnsimulatedmemory.h"
#include "core/values/sensorconfig.h"

#include <QByteArrayList>

#include <memory>
#include <optional>

namespace gorizont::usmisn {

/// An УСМ-ИСН on a simulated line: its memory, its watchdog, its first second at 9600, its sleep as a recorder. Written from
/// manual 002 beside the codec, not with it, so that the two check each other. Time is given: it catches up with a month of
/// sleep when it is next spoken to.
class Simulator : public SimulatedDevice
{
public:
    Simulator(const SensorConfig &sensor, quint64 seed);

    QByteArray receive(QByteArrayView bytes, Time now) override;
    Time workTime() const override { return m_workTime; }
    void hostSpeaks(const PortSettings &port) override;
    void reboot(Time now) override;
    void overrunRing(Time now) override;

    void setOutOfRange(bool isOut) { m_isOutOfRange = isOut; } ///< of both axes, from now on
    void setBroken(bool isBroken) { m_isBroken = isBroken; } ///< its transducer
    void setType(const QByteArray &type) { m_type = type; } ///< `028`

    quint32 serial() const { return m_serial; }
    int resets() const { return m_resets; } ///< by the watchdog, as far as known
    bool isRecording() const { return m_recorder.has_value(); }
    const PortSettings &ownPort() const { return m_ownPort; }
    const SimulatedMemory &memory() const { return m_memory; }

private:
    struct Request
    {
        QByteArray addressText;
        QByteArray transaction;
        QByteArray command;
        QByteArray data;
        bool isToAll = false;
    };
    struct Recorder
    {
        Time since{0}; ///< when it was started
        qint64 clock = 0; ///< what its clock showed then, seconds since 1970
        qint64 start = 0;
        qint64 period = 0; ///< seconds
        qint64 delay = 0; ///< seconds
        qint64 measured = 0; ///< how often
    };

    void catchUp(Time now);
    bool isListening(Time now) const;
    QByteArray obey(const QByteArray &message, Time now);
    QByteArray identity(const Request &request) const;
    QByteArray setting(const Request &request, Time now);
    QByteArray setPort(const Request &request);
    QByteArray startCycle(const Request &request, Time now);
    QByteArray value(const Request &request, Time now);
    QByteArray records(const Request &request);
    QByteArray reply(const Request &request, const QByteArray &data, const QByteArray &address = {}) const;
    int channelNamed(const QByteArray &text, bool isToAll) const;
    SimulatedMemory::Record measured(int channel, qint64 timestamp, Time at) const;
    QByteArray fields(const SimulatedMemory::Record &record) const;

    BuildingMotion m_motion;
    quint32 m_serial;
    QByteArray m_type = QByteArrayLiteral("028");
    PortSettings m_ownPort; ///< what it listens at after its first second
    PortSettings m_hostPort;
    bool m_hasHost = false;
    SimulatedMemory m_memory;
    std::optional<Recorder> m_recorder;
    bool m_isOutOfRange = false;
    bool m_isBroken = false;
    Time m_bootedAt{0};
    Time m_heardAt{0}; ///< the last message
    Time m_workTime{0};
    int m_resets = 0;
    quint32 m_lastCrc = 0;
    QByteArray m_buffer; ///< of a message that is not over
};

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::usmisn
