#include "app/server/feeds.h"

#include "app/server/archive.h"
#include "core/history/historywriter.h"

namespace gorizont {

namespace {

MetricFamily single(const char *name, MetricFamily::Type type, const char *help, double value)
{
    return {QByteArray(name), type, QString::fromLatin1(help), {{{}, value}}};
}

MetricFamilies historyMetrics(const HistoryInbox::Backlog &backlog)
{
    using Type = MetricFamily::Type;
    return {
        single(
            "gorizont_history_waiting_samples", Type::Gauge, "Samples that wait for the disk.",
            static_cast<double>(backlog.samples)),
        single(
            "gorizont_history_waiting_events", Type::Gauge, "Events of the journal that wait for the disk.",
            static_cast<double>(backlog.entries)),
    };
}

MetricFamilies archiveMetrics(std::size_t waiting)
{
    return {single(
        "gorizont_archive_waiting_readings", MetricFamily::Type::Gauge, "Readings that wait for the archive.",
        static_cast<double>(waiting))};
}

MetricFamilies mqttMetrics(const MqttStatus &status)
{
    using Type = MetricFamily::Type;
    return {
        single("gorizont_mqtt_connected", Type::Gauge, "1 while the broker is connected.", status.isConnected ? 1 : 0),
        single(
            "gorizont_mqtt_waiting_readings", Type::Gauge, "Readings that wait for the broker.",
            static_cast<double>(status.waiting)),
        single(
            "gorizont_mqtt_queue_bytes", Type::Gauge, "Size of the queue on the disk.",
            static_cast<double>(status.bytesOnDisk)),
        single(
            "gorizont_mqtt_published_readings_total", Type::Counter, "Readings that the broker has confirmed.",
            static_cast<double>(status.published)),
        single(
            "gorizont_mqtt_lost_readings_total", Type::Counter, "Readings that were lost because there was no room.",
            static_cast<double>(status.lost)),
    };
}

} // namespace

Feeds::Feeds(const Site &site)
{
    m_mqttThread.setObjectName(QStringLiteral("mqtt"));
    if (site.config.metrics.isOn()) {
        makeMetrics(site);
    }
    if (site.config.mqtt.isOn() && site.ownsDataFolder) {
        makeMqtt(site);
    }
}

void Feeds::makeMetrics(const Site &site)
{
    MetricsServer::Settings settings;
    settings.metrics = site.config.metrics;
    m_metrics = std::make_unique<MetricsServer>(settings, site.config.lines);
    MetricsBoard *board = &m_metrics->board();
    connect(&site.registry, &SensorRegistry::readingsChanged, this, [board](const Readings &batch) {
        board->put(batch);
    });
    connect(&site.registry, &SensorRegistry::lineChanged, this, [board](const LineStatus &status) {
        board->put(status);
    });
    board->put(site.registry.readings());
    for (const LineStatus &status : site.registry.lineStatuses()) {
        board->put(status);
    }
    connect(&m_round, &QTimer::timeout, this, [board, history = &site.history, archive = &site.archive] {
        board->put(QStringLiteral("history"), historyMetrics(history->backlog()));
        board->put(QStringLiteral("archive"), archiveMetrics(archive->backlog()));
    });
    connect(m_metrics.get(), &MetricsServer::journal, &site.journal, &Journal::append);
    m_metrics->moveToThread(&site.servers);
    connect(&site.servers, &QThread::started, m_metrics.get(), &MetricsServer::start);
    connect(&site.servers, &QThread::finished, m_metrics.get(), &MetricsServer::stop, Qt::DirectConnection);
}

void Feeds::makeMqtt(const Site &site)
{
    m_mqtt = std::make_unique<MqttPublisher>(mqttConfig(site.config, site.dataFolder));
    MqttPublisher *mqtt = m_mqtt.get();
    // Direct: the slots only leave the values in an inbox of bounded size.
    connect(
        &site.registry, &SensorRegistry::readingsChanged, mqtt, &MqttPublisher::updateReadings, Qt::DirectConnection);
    connect(&site.registry, &SensorRegistry::lineChanged, mqtt, &MqttPublisher::updateLine, Qt::DirectConnection);
    connect(mqtt, &MqttPublisher::journal, &site.journal, &Journal::append);
    connect(mqtt, &MqttPublisher::statusChanged, this, &Feeds::mqttStatusChanged);
    if (m_metrics) {
        MetricsBoard *board = &m_metrics->board();
        board->put(QStringLiteral("mqtt"), mqttMetrics({}));
        connect(mqtt, &MqttPublisher::statusChanged, this, [board](const MqttStatus &status) {
            board->put(QStringLiteral("mqtt"), mqttMetrics(status));
        });
    }
    mqtt->updateReadings(site.registry.readings());
    for (const LineStatus &status : site.registry.lineStatuses()) {
        mqtt->updateLine(status);
    }
    mqtt->moveToThread(&m_mqttThread);
    connect(&m_mqttThread, &QThread::started, mqtt, &MqttPublisher::start);
    connect(&m_mqttThread, &QThread::finished, mqtt, &MqttPublisher::stop, Qt::DirectConnection);
}

void Feeds::start()
{
    if (m_mqtt) {
        m_mqttThread.start();
    }
    if (m_metrics) {
        m_round.start(std::chrono::seconds(1));
    }
}

void Feeds::stop()
{
    m_round.stop();
    m_mqttThread.quit();
}

void Feeds::setClients(const QString &service, qsizetype count)
{
    m_clients.insert(service, count);
    if (!m_metrics) {
        return;
    }
    MetricFamily family{
        "gorizont_server_clients", MetricFamily::Type::Gauge, QStringLiteral("Clients that are connected."), {}};
    for (auto clients = m_clients.cbegin(); clients != m_clients.cend(); ++clients) {
        family.samples.append({{{"server", clients.key()}}, static_cast<double>(clients.value())});
    }
    m_metrics->board().put(QStringLiteral("clients"), {family});
}

} // namespace gorizont
