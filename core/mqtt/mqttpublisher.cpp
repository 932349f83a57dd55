#include "core/mqtt/mqttpublisher.h"

#include "core/mqtt/mqttmessages.h"
#include "core/mqtt/mqttsentences.h"
#include "core/mqtt/mqtttopics.h"
#include "core/values/readingjson.h"

#include <QRandomGenerator>

#include <algorithm>

namespace gorizont {

namespace {

BrokerSession::Access accessOf(const MqttConfig &config)
{
    return {
        config.settings, mqtttopic::under(config.settings.prefix, mqtttopic::status()), config.window, config.keepAlive,
        config.connectLimit};
}

/// Whether the operator has heard as much already: a broker that is lost cannot be reached either.
bool isNews(BrokerTrouble trouble, std::optional<BrokerTrouble> told)
{
    const auto isAway = [](BrokerTrouble one) {
        return one == BrokerTrouble::Unreachable || one == BrokerTrouble::NoAnswer || one == BrokerTrouble::Lost;
    };
    return !told || (*told != trouble && !(isAway(*told) && isAway(trouble)));
}

} // namespace

MqttPublisher::MqttPublisher(const MqttConfig &config, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_inbox(config.mostReadings)
    , m_pace(config.settings.interval)
    , m_queue(config.folder, config.queue, [this](JournalKind kind, const QString &text) { tell(kind, text); })
    , m_session(accessOf(config), this)
    , m_round(this)
    , m_reconnect(this)
    , m_calm(this)
{
    for (const LineConfig &line : config.lines) {
        LineConfig alone = line;
        alone.sensors.clear();
        m_lines.insert(line.index, alone);
        for (const SensorConfig &sensor : line.sensors) {
            m_known.insert(sensor.number, {sensor, alone});
            m_pace.begin(sensor.number, initialSensorWord(line, sensor, config.rules));
        }
    }
    m_round.setInterval(1000);
    m_reconnect.setSingleShot(true);
    m_calm.setSingleShot(true);
    m_calm.setInterval(config.calm);
    connect(&m_round, &QTimer::timeout, this, &MqttPublisher::lookAround);
    connect(&m_reconnect, &QTimer::timeout, &m_session, &BrokerSession::open);
    connect(&m_calm, &QTimer::timeout, this, [this] { m_pause.reset(); });
    connect(&m_session, &BrokerSession::connected, this, &MqttPublisher::onConnected);
    connect(&m_session, &BrokerSession::published, this, &MqttPublisher::onPublished);
    connect(&m_session, &BrokerSession::ended, this, &MqttPublisher::onEnded);
}

void MqttPublisher::updateReadings(const QList<Reading> &batch)
{
    wake(m_inbox.put(batch));
}

void MqttPublisher::updateLine(const LineStatus &status)
{
    wake(m_inbox.put(status));
}

void MqttPublisher::wake(bool isNeeded)
{
    if (isNeeded) {
        QMetaObject::invokeMethod(this, &MqttPublisher::takeInbox, Qt::QueuedConnection);
    }
}

void MqttPublisher::start()
{
    m_queue.open(utcNow());
    m_isRunning = true;
    m_round.start();
    takeInbox();
    m_session.open();
}

void MqttPublisher::stop()
{
    if (!m_isRunning) {
        return;
    }
    takeInbox();
    m_isRunning = false;
    m_round.stop();
    m_reconnect.stop();
    m_calm.stop();
    m_session.close(QByteArrayLiteral("offline"));
    m_readingsUnderway.clear();
    lookAround();
}

/// What comes before start() waits until the queue is open.
void MqttPublisher::takeInbox()
{
    if (!m_isRunning) {
        return;
    }
    const MqttInbox::Contents contents = m_inbox.take();
    if (contents.readingsDropped > 0) {
        m_dropped += contents.readingsDropped;
        tell(JournalKind::Error, mqttsentence::heldUp(contents.readingsDropped));
    }
    takeReadings(contents.readings);
    for (const LineStatus &status : contents.lines) {
        takeLine(status);
    }
    pump();
}

void MqttPublisher::takeReadings(const Readings &readings)
{
    QList<QueuedMessage> messages;
    quint64 sequence = m_queue.nextSequence();
    for (const Reading &reading : readings) {
        const auto known = m_known.constFind(reading.number);
        if (known == m_known.constEnd()) {
            continue;
        }
        const PublishingPace::Verdict verdict = m_pace.judge(reading);
        const QByteArray stateTopic = mqtttopic::sensorState(reading.number);
        if (verdict.isNewState || !m_states.contains(stateTopic)) {
            setState(stateTopic, mqttmessage::sensorState(reading, known->sensor, known->line));
        }
        if (verdict.isSent) {
            const QByteArray json = readingToJson(reading, known->sensor, known->line);
            messages.append({sequence, mqtttopic::sensorReading(reading.number), mqttmessage::reading(json, sequence)});
            ++sequence;
        }
    }
    if (!messages.isEmpty()) {
        m_queue.append(messages);
    }
}

void MqttPublisher::takeLine(const LineStatus &status)
{
    const auto line = m_lines.constFind(status.port);
    const auto known = m_lineStates.constFind(status.port);
    if (line == m_lines.constEnd() || (known != m_lineStates.constEnd() && *known == status.state)) {
        return;
    }
    m_lineStates.insert(status.port, status.state);
    setState(mqtttopic::portState(status.port), mqttmessage::portState(utcNow(), status, *line));
}

void MqttPublisher::setState(const QByteArray &topic, const QByteArray &payload)
{
    m_states.insert(topic, payload);
    m_unsentStates.insert(topic);
}

/// As many as may be on their way: states first, they are few, then readings from the oldest on.
void MqttPublisher::pump()
{
    while (
        m_session.isConnected()
        && std::cmp_less(m_readingsUnderway.size() + static_cast<std::size_t>(m_statesUnderway.size()), m_config.window)
        && (sendState() || sendReading())) {
    }
}

bool MqttPublisher::sendState()
{
    if (m_unsentStates.isEmpty()) {
        return false;
    }
    const QByteArray topic = *m_unsentStates.constBegin();
    const auto message =
        m_session.publish(mqtttopic::under(m_config.settings.prefix, topic), m_states.value(topic), true);
    if (message) {
        m_unsentStates.remove(topic);
        m_statesUnderway.insert(*message, topic);
    }
    return message.has_value();
}

bool MqttPublisher::sendReading()
{
    const auto reading = m_queue.next();
    if (!reading) {
        return false;
    }
    const auto message =
        m_session.publish(mqtttopic::under(m_config.settings.prefix, reading->topic), reading->payload, false);
    if (message) {
        m_readingsUnderway.push_back({*message, reading->sequence});
    }
    return message.has_value(); // otherwise the session ends, and the queue begins anew
}

void MqttPublisher::onConnected()
{
    m_told.reset();
    m_calm.start();
    setState(mqtttopic::status(), QByteArrayLiteral("online"));
    for (auto state = m_states.keyBegin(); state != m_states.keyEnd(); ++state) {
        m_unsentStates.insert(*state);
    }
    tell(JournalKind::On, mqttsentence::connected(m_config.settings, m_queue.waiting()));
    pump();
}

void MqttPublisher::onPublished(const QList<int> &messages)
{
    for (const int message : messages) {
        if (m_statesUnderway.remove(message)) {
            continue;
        }
        const auto found =
            std::find_if(m_readingsUnderway.begin(), m_readingsUnderway.end(), [message](const Underway &one) {
                return one.message == message;
            });
        if (found != m_readingsUnderway.end()) {
            found->isThere = true;
        }
    }
    std::optional<quint64> last;
    while (!m_readingsUnderway.empty() && m_readingsUnderway.front().isThere) {
        last = m_readingsUnderway.front().sequence;
        m_readingsUnderway.pop_front();
        ++m_published;
    }
    if (last) {
        m_queue.acknowledge(*last);
    }
    pump();
}

void MqttPublisher::onEnded(BrokerTrouble trouble, const QString &detail)
{
    m_calm.stop();
    m_statesUnderway.clear();
    m_readingsUnderway.clear();
    m_queue.rewind();
    if (isNews(trouble, m_told)) {
        tell(JournalKind::Error, mqttsentence::trouble(trouble, m_config.settings, detail));
    }
    m_told = trouble;
    m_reconnect.start(m_pause.next(QRandomGenerator::global()->generateDouble()));
}

void MqttPublisher::lookAround()
{
    m_queue.save();
    const MqttStatus status{
        m_session.isConnected(), m_queue.waiting(), m_queue.bytesOnDisk(), m_published, m_queue.lost() + m_dropped};
    if (m_status != status) {
        m_status = status;
        Q_EMIT statusChanged(status);
    }
}

void MqttPublisher::tell(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, utcNow(), text});
}

} // namespace gorizont
