#pragma once

#include "core/devices/mk14/mk14parameters.h"
#include "core/devices/mk14/mk14simulatedweather.h"
#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <QHash>

#include <memory>
#include <optional>

namespace gorizont::mk14 {

/// A weather station АКП on a simulated line. Written from manual 004 beside the codec, not with it, so that the two check each
/// other. Its digital inputs: bit 0 the mains, bit 1 it rains, bits 16…31 the outputs 0…15.
class Simulator : public SimulatedDevice
{
public:
    /// \a clock: what the station's clock shows at the start of the simulation, seconds since 1970.
    Simulator(const SensorConfig &sensor, quint64 seed, qint64 clock);

    QByteArray receive(QByteArrayView bytes, Time now) override;
    Time workTime() const override { return m_workTime; }
    /// Its outputs fall off, its files and its clock stay; it has no data for startTime.
    void reboot(Time now) override;

    static constexpr std::chrono::seconds startTime{5};

    void setSupplyBad(bool isBad) { m_isSupplyBad = isBad; } ///< then every value is
    void setHasData(bool hasData) { m_hasData = hasData; }
    /// Instead of all values of the parameters with \a code, its bits as they are.
    void setValue(QChar code, float value) { m_fixed.insert(code, value); }

    quint32 outputs() const { return m_outputs; }
    qint64 clock(Time now) const; ///< seconds since 1970
    QHash<QByteArray, QByteArray> files() const { return m_files; } ///< that were sent to it, by name

private:
    struct Statistics
    {
        double mean = 0;
        double minimum = 0;
        double maximum = 0; ///< since the last request, at least of the last second
        double deviation = 0;
    };

    QByteArray takeRequest(Time now);
    QByteArray obey(const QByteArray &request, Time now);
    QByteArray data(int command, Time now) const;
    QByteArray extras(Time now) const;
    void appendParameter(QByteArray &block, const ParameterName &parameter, int command, Time now) const;
    Statistics statistics(const ParameterName &parameter, Time now) const;
    quint32 inputs(Time now) const;
    void appendValue(QByteArray &block, QChar code, double value) const;

    SimulatedWeather m_weather;
    QList<ParameterName> m_parameters;
    qint64 m_clockAtStart;
    quint32 m_outputs = 0;
    QHash<QByteArray, QByteArray> m_files;
    QHash<QChar, float> m_fixed;
    bool m_isSupplyBad = false;
    bool m_hasData = true;
    std::optional<Time> m_startedAt; ///< empty: it has been at work for long
    Time m_askedAt{0}; ///< the last request for data
    Time m_heardAt{0};
    Time m_workTime{0};
    QByteArray m_heard;
};

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::mk14
