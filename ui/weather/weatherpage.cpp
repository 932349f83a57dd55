#include "ui/weather/weatherpage.h"

#include "ui/models/health.h"
#include "ui/models/propertymodel.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"
#include "ui/models/weatherproperties.h"
#include "ui/models/weathertext.h"
#include "ui/pages/tableview.h"
#include "ui/weather/inputlamps.h"
#include "ui/weather/precipitationmodel.h"
#include "ui/weather/weathermodel.h"
#include "ui/weather/windlog.h"
#include "ui/weather/windroseview.h"

#include <QComboBox>
#include <QLabel>
#include <QTimer>

#include <algorithm>

namespace gorizont {

namespace {

bool isStation(const SensorRegistry::Sensor &sensor)
{
    return sensor.config.type == SensorType::Mk14;
}

/// The option `StationClock{i}` of a station.
precipitation::StationClock clockOf(const SensorConfig &sensor)
{
    const QString clock = sensor.options.value(QStringLiteral("stationclock")).trimmed();
    return clock.compare(QStringLiteral("UTC"), Qt::CaseInsensitive) == 0 ? precipitation::StationClock::Utc
                                                                          : precipitation::StationClock::Local;
}

bool hasAnyValue(const Weather &weather)
{
    return std::ranges::any_of(weather.parameters, [](const WeatherParameter &parameter) {
        return parameter.mean || parameter.instant || parameter.maxPeriod;
    });
}

} // namespace

bool WeatherPage::hasStation(const SensorRegistry &registry)
{
    return std::ranges::any_of(registry.sensors(), isStation);
}

WeatherPage::WeatherPage(const SensorRegistry &registry, QWidget *parent, Clock now)
    : QWidget(parent)
    , m_registry(registry)
    , m_now(std::move(now))
    , m_log(new WindLog(registry, this))
    , m_stations(new QComboBox(this))
    , m_spans(new QComboBox(this))
    , m_status(new QLabel(this))
    , m_age(new QLabel(this))
    , m_rose(new WindRoseView(this))
    , m_wind(new PropertyModel(false, this))
    , m_windTable(new TableView(QStringLiteral("windTable"), this))
    , m_lamps(new InputLamps(this))
    , m_inputs(new QLabel(this))
    , m_rain(new PrecipitationModel(this))
    , m_rainTable(new TableView(QStringLiteral("rainTable"), this))
    , m_parameters(new WeatherModel(this))
    , m_table(new TableView(QStringLiteral("weatherTable"), this))
    , m_files(new StationFilesModel(this))
    , m_filesTable(new TableView(QStringLiteral("stationFilesTable"), this))
    , m_tick(new QTimer(this))
{
    setObjectName(QStringLiteral("weatherPage"));
    build();
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        if (isStation(sensor)) {
            m_stations->addItem(statetext::sensorTitle(sensor.config), sensor.config.number);
        }
    }
    m_stations->setEnabled(m_stations->count() > 1);
    m_tick->setInterval(std::chrono::milliseconds(250));
    connect(m_tick, &QTimer::timeout, this, &WeatherPage::tick);
    connect(&registry, &SensorRegistry::readingsChanged, this, [this] { m_isDirty = true; });
    connect(&registry, &SensorRegistry::lineChanged, this, [this] { m_isDirty = true; });
    connect(m_stations, &QComboBox::currentIndexChanged, this, &WeatherPage::choose);
    connect(m_spans, &QComboBox::currentIndexChanged, this, &WeatherPage::refresh);
    choose();
}

void WeatherPage::showStation(int number)
{
    if (const int index = m_stations->findData(number); index >= 0) {
        m_stations->setCurrentIndex(index);
    }
}

int WeatherPage::station() const
{
    return m_stations->currentData().toInt();
}

void WeatherPage::setFileComplaints(int number, const QList<StationFileComplaint> &complaints)
{
    m_complaints.insert(number, complaints);
    refresh();
}

const SensorRegistry::Sensor *WeatherPage::sensor() const
{
    const int index = m_registry.indexOf(station());
    return index < 0 ? nullptr : &m_registry.sensors()[static_cast<std::size_t>(index)];
}

LineState WeatherPage::lineState(const SensorRegistry::Sensor &sensor) const
{
    return m_registry.lines()[static_cast<std::size_t>(sensor.line)].status.state;
}

void WeatherPage::choose()
{
    m_table->clearSelection();
    m_rainTable->clearSelection();
    refresh();
}

/// Readings of a site come in batches, many a second; the age goes on without them.
void WeatherPage::tick()
{
    if (window()->isMinimized()) {
        return;
    }
    if (m_isDirty) {
        refresh();
    } else {
        showAge();
    }
}

void WeatherPage::refresh()
{
    m_isDirty = false;
    const SensorRegistry::Sensor *station = sensor();
    if (!station) {
        m_status->setText(tr("The configuration names no weather station (МК-14)."));
        showWind(0, nullptr);
        return;
    }
    const Weather *shown = shownWeather(*station, lineState(*station));
    m_status->setText(statusOf(*station, shown));
    showParameters(*station, shown);
    showRain(*station);
    showWind(station->config.number, shown);
    m_files->setComplaints(m_complaints.value(station->config.number));
    m_filesTable->setVisible(m_files->rowCount() > 0);
    showAge();
}

/// One sentence: what is wrong, or that all is well.
QString WeatherPage::statusOf(const SensorRegistry::Sensor &sensor, const Weather *shown) const
{
    const LineState line = lineState(sensor);
    if (!shown) {
        return statetext::sensor(sensor, line) + u'.';
    }
    if (shown->parameters.isEmpty()) {
        return tr("The station answers, but it has no data yet.");
    }
    if (statusCode(sensor.reading.status) == StatusCode::TransducerSilent) {
        return tr("%1: its values are not to be trusted. Check the power supply.").arg(statetext::sensor(sensor, line));
    }
    if (!hasAnyValue(*shown)) {
        return tr("The station answers, but none of its values is valid.");
    }
    return statetext::sensor(sensor, line) + u'.';
}

void WeatherPage::showParameters(const SensorRegistry::Sensor &sensor, const Weather *shown)
{
    const auto &known = sensor.reading.weather;
    m_parameters->setParameters(known ? known->parameters : QList<WeatherParameter>(), shown != nullptr);
    m_table->setEmptyText(
        known ? tr("The station has no data. It sends them as soon as it has measured.")
              : tr("The station has not answered yet. Its parameters are listed after the first answer."));
    m_lamps->setInputs(shown ? std::optional(shown->digital) : std::nullopt);
    m_inputs->setText(shown ? weathertext::digital(shown->digital) : valuetext::absent());
}

/// When it rained does not become wrong because a station falls silent; only whether it still rains is not known then.
void WeatherPage::showRain(const SensorRegistry::Sensor &sensor)
{
    const auto &known = sensor.reading.weather;
    const auto clock = clockOf(sensor.config);
    m_rain->setSpells(precipitation::spells(known ? known->events : QList<PrecipitationEvent>()), clock);
    m_rain->setNow(precipitation::stationTime(m_now(), clock));
}

void WeatherPage::showWind(int number, const Weather *shown)
{
    const auto span = std::chrono::minutes(m_spans->currentData().toInt());
    const WindCounts counts = m_log->over(number, span, std::chrono::steady_clock::now());
    m_rose->show(counts, shown ? WindNow::of(*shown) : WindNow(), m_spans->currentText());
    m_wind->setProperties(windProperties(shown, counts));
}

void WeatherPage::showAge()
{
    const SensorRegistry::Sensor *station = sensor();
    const auto answered = station ? station->reading.answeredAt : std::nullopt;
    m_age->setText(
        answered ? tr("Age of the data: %1").arg(valuetext::age(std::chrono::steady_clock::now() - *answered))
                 : QString());
}

void WeatherPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
    m_tick->start();
}

void WeatherPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick->stop();
}

} // namespace gorizont
