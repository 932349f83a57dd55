#include "core/metrics/sitemetrics.h"

#include "core/values/statusword.h"

#include <array>
#include <functional>

namespace gorizont {

namespace {

using Type = MetricFamily::Type;
using Labels = QList<QPair<QByteArray, QString>>;

constexpr double millimetresPerMetre = 1000;
constexpr double percent = 100;

double seconds(std::chrono::nanoseconds duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// One family, filled port by port or sensor by sensor.
MetricFamily family(const char *name, Type type, const char *help)
{
    return {QByteArray(name), type, QString::fromLatin1(help), {}};
}

Labels with(Labels labels, const char *name, const QString &value)
{
    labels.append({QByteArray(name), value});
    return labels;
}

template <typename Counts> struct Counter
{
    const char *name;
    const char *help;
    quint64 Counts::*count;
};
using PortCounter = Counter<LineStatus>;
using SensorCounter = Counter<SensorCounters>;

constexpr std::array portCounters{
    PortCounter{"gorizont_port_sent_bytes_total", "Bytes written to the port.", &LineStatus::bytesSent},
    PortCounter{"gorizont_port_received_bytes_total", "Bytes read from the port.", &LineStatus::bytesReceived},
    PortCounter{"gorizont_port_failed_opens_total", "Attempts to open the port that failed.", &LineStatus::failedOpens},
    PortCounter{"gorizont_port_write_errors_total", "Writes to the port that failed.", &LineStatus::writeErrors},
    PortCounter{"gorizont_port_read_errors_total", "Requests without a usable answer.", &LineStatus::readErrors},
    PortCounter{"gorizont_port_crc_errors_total", "Answers with a wrong check sum.", &LineStatus::crcErrors},
};

constexpr std::array<std::pair<LineState, const char *>, 6> lineStates{{
    {LineState::Off, "off"},
    {LineState::Opening, "opening"},
    {LineState::Open, "open"},
    {LineState::OpenFailed, "open_failed"},
    {LineState::Lost, "lost"},
    {LineState::Service, "service"},
}};

MetricFamilies portMetrics(const SiteSnapshot &site)
{
    MetricFamilies families;
    for (const PortCounter &counter : portCounters) {
        families.append(family(counter.name, Type::Counter, counter.help));
    }
    MetricFamily states =
        family("gorizont_port_state", Type::Gauge, "1 at the state that the port is in, 0 at others.");
    for (const LineConfig &line : site.lines) {
        const LineStatus status = site.statuses.value(line.index);
        const Labels labels{{"port", line.title()}, {"index", QString::number(line.index)}};
        for (std::size_t i = 0; i < portCounters.size(); ++i) {
            families[static_cast<qsizetype>(i)].samples.append(
                {labels, static_cast<double>(status.*portCounters[i].count)});
        }
        for (const auto &[state, name] : lineStates) {
            const double value = status.state == state ? 1 : 0;
            states.samples.append({with(labels, "state", QString::fromLatin1(name)), value});
        }
    }
    families.append(states);
    return families;
}

constexpr std::array sensorCounters{
    SensorCounter{"gorizont_sensor_answers_total", "Good answers of the sensor.", &SensorCounters::answers},
    SensorCounter{
        "gorizont_sensor_read_errors_total", "Requests without a usable answer.", &SensorCounters::readErrors},
    SensorCounter{"gorizont_sensor_crc_errors_total", "Answers with a wrong check sum.", &SensorCounters::crcErrors},
};

/// A gauge of one sensor; an empty value leaves the sensor out.
struct SensorGauge
{
    const char *name;
    const char *help;
    const char *axis; ///< label `axis`; empty: none
    std::function<std::optional<double>(const Reading &)> value;
};

std::optional<double> tilt(const Reading &reading, double Tilt::*axis)
{
    const bool isKnown = reading.tilt && isTiltValid(reading.status);
    return isKnown ? std::optional(*reading.tilt.*axis) : std::nullopt;
}

std::optional<double> acceleration(const Reading &reading, double AccelStatistics::*part, double scale)
{
    const bool isKnown = reading.acceleration && isAccelerationValid(reading.status);
    return isKnown ? std::optional(*reading.acceleration.*part / scale) : std::nullopt;
}

const QList<SensorGauge> &valueGauges()
{
    static const char *const tiltName = "gorizont_sensor_tilt_arcseconds";
    static const char *const tiltHelp = "Tilt, corrected by offsets and rotation of the sensor.";
    static const char *const rmsName = "gorizont_sensor_acceleration_rms_meters_per_second_squared";
    static const char *const rmsHelp = "Root mean square of the acceleration in the last minute.";
    static const QList<SensorGauge> gauges{
        {tiltName, tiltHelp, "x", [](const Reading &r) { return tilt(r, &Tilt::x); }},
        {tiltName, tiltHelp, "y", [](const Reading &r) { return tilt(r, &Tilt::y); }},
        {"gorizont_sensor_temperature_celsius", "Temperature in the sensor.", "",
         [](const Reading &r) { return isTemperatureValid(r.status) ? r.temperature : std::nullopt; }},
        {"gorizont_sensor_heater_ratio", "Power of the heater, 0 to 1.", "",
         [](const Reading &r) { return r.heaterPower ? std::optional(*r.heaterPower / percent) : std::nullopt; }},
        {"gorizont_sensor_fan_hertz", "Turns of the fan.", "", [](const Reading &r) { return r.fanFrequency; }},
        {"gorizont_sensor_acceleration_maximum_meters_per_second_squared",
         "Modulus of the largest acceleration in the last minute.", "",
         [](const Reading &r) { return acceleration(r, &AccelStatistics::maximum, millimetresPerMetre); }},
        {"gorizont_sensor_acceleration_direction_degrees", "Direction of the largest acceleration.", "",
         [](const Reading &r) { return acceleration(r, &AccelStatistics::direction, 1); }},
        {rmsName, rmsHelp, "x",
         [](const Reading &r) { return acceleration(r, &AccelStatistics::rmsX, millimetresPerMetre); }},
        {rmsName, rmsHelp, "y",
         [](const Reading &r) { return acceleration(r, &AccelStatistics::rmsY, millimetresPerMetre); }},
    };
    return gauges;
}

QList<SensorGauge> stateGauges(SteadyTime now)
{
    return {
        {"gorizont_sensor_status_code", "Critical code of the status word, 0: good (manual, section 11.2).", "",
         [](const Reading &r) { return static_cast<double>(statusCode(r.status)); }},
        {"gorizont_sensor_last_answer_age_seconds", "Time since the last good answer.", "",
         [now](const Reading &r) { return r.answeredAt ? std::optional(seconds(now - *r.answeredAt)) : std::nullopt; }},
        {"gorizont_sensor_poll_period_seconds", "Time between the last two polls.", "",
         [](const Reading &r) { return r.period.count() > 0 ? std::optional(seconds(r.period)) : std::nullopt; }},
        {"gorizont_sensor_exchange_seconds", "How long the last poll took.", "",
         [](const Reading &r) { return r.exchange.count() > 0 ? std::optional(seconds(r.exchange)) : std::nullopt; }},
    };
}

struct LabelledReading
{
    Labels labels;
    Reading reading;
};

QList<LabelledReading> sensorsOf(const SiteSnapshot &site)
{
    QList<LabelledReading> sensors;
    for (const LineConfig &line : site.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            if (site.readings.contains(sensor.number)) {
                const Labels labels{
                    {"port", line.title()}, {"sensor", QString::number(sensor.number)}, {"type", sensor.model}};
                sensors.append({labels, site.readings.value(sensor.number)});
            }
        }
    }
    return sensors;
}

/// Gauges of one name that stand together are one family.
void appendGauges(MetricFamilies &families, const QList<SensorGauge> &gauges, const QList<LabelledReading> &sensors)
{
    for (const SensorGauge &gauge : gauges) {
        if (families.isEmpty() || families.last().name != gauge.name) {
            families.append(family(gauge.name, Type::Gauge, gauge.help));
        }
        for (const LabelledReading &sensor : sensors) {
            if (const auto value = gauge.value(sensor.reading)) {
                const QString axis = QString::fromLatin1(gauge.axis);
                families.last().samples.append(
                    {axis.isEmpty() ? sensor.labels : with(sensor.labels, "axis", axis), *value});
            }
        }
    }
}

MetricFamilies sensorMetrics(const SiteSnapshot &site)
{
    const QList<LabelledReading> sensors = sensorsOf(site);
    MetricFamilies families;
    for (const SensorCounter &counter : sensorCounters) {
        families.append(family(counter.name, Type::Counter, counter.help));
        for (const LabelledReading &sensor : sensors) {
            families.last().samples.append(
                {sensor.labels, static_cast<double>(sensor.reading.counters.*counter.count)});
        }
    }
    appendGauges(families, stateGauges(site.now), sensors);
    appendGauges(families, valueGauges(), sensors);
    return families;
}

MetricFamilies programMetrics(const SiteSnapshot &site)
{
    MetricFamily build = family("gorizont_build_info", Type::Gauge, "1; the version stands in the label.");
    build.samples.append({{{"version", QStringLiteral(GORIZONT_VERSION)}}, 1});
    MetricFamily uptime = family("gorizont_uptime_seconds", Type::Gauge, "Time since the program started.");
    uptime.samples.append({{}, seconds(site.now - site.started)});
    return {build, uptime};
}

} // namespace

MetricFamilies siteMetrics(const SiteSnapshot &site)
{
    return programMetrics(site) + portMetrics(site) + sensorMetrics(site);
}

} // namespace gorizont
