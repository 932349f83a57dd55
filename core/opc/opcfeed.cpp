#include "core/opc/opcfeed.h"

#include "core/net/allowlist.h"
#include "core/opc/opcsentences.h"

#include <algorithm>

namespace gorizont {

OpcFeedConfig opcFeedConfig(const ServerConfig &config, const OpcWeather &weather)
{
    OpcFeedConfig feed;
    feed.port = config.opc.port;
    feed.caption = config.caption;
    feed.lines = config.lines;
    feed.weather = weather;
    return feed;
}

OpcFeed::OpcFeed(const OpcFeedConfig &config, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_image(config.lines, opcTags(config.lines, config.weather), utcNow())
    , m_opening{opclines::hello(config.caption, m_image.tags()), opclines::tagLines(m_image.tags())}
    , m_sentences(service(), QStringLiteral("[OPC] Port"))
    , m_server(this)
    , m_retry(this)
    , m_gather(this)
    , m_round(this)
{
    m_retry.setInterval(config.retry);
    m_gather.setInterval(config.gather);
    m_gather.setSingleShot(true);
    m_round.setInterval(std::chrono::seconds(1));
    connect(&m_retry, &QTimer::timeout, this, &OpcFeed::tryToListen);
    connect(&m_round, &QTimer::timeout, this, &OpcFeed::lookAround);
    connect(&m_gather, &QTimer::timeout, this, [this] {
        for (OpcGateway *gateway : m_gateways) {
            gateway->passChanges();
        }
    });
    connect(&m_server, &QTcpServer::newConnection, this, &OpcFeed::admit);
}

OpcFeed::~OpcFeed()
{
    qDeleteAll(m_gateways); // before the image they read
}

void OpcFeed::start()
{
    m_retry.start();
    tryToListen();
}

/// Loopback only: nothing here asks who somebody is.
void OpcFeed::tryToListen()
{
    if (m_server.listen(QHostAddress::LocalHost, static_cast<quint16>(m_config.port))) {
        m_retry.stop();
        m_toldError.reset();
        m_round.start();
        tell(JournalKind::On, opcsentences::listening(port()));
        Q_EMIT listening(port());
    } else if (m_toldError != m_server.serverError()) {
        m_toldError = m_server.serverError();
        const auto retry = std::chrono::ceil<std::chrono::seconds>(m_config.retry);
        tell(JournalKind::Error, m_sentences.cannotListen(m_config.port, *m_toldError, m_server.errorString(), retry));
    }
}

void OpcFeed::stop()
{
    const bool wasListening = m_server.isListening();
    m_server.close();
    m_retry.stop();
    m_gather.stop();
    m_round.stop();
    for (OpcGateway *gateway : m_gateways) {
        gateway->sayGoodbye();
        gateway->deleteLater();
    }
    m_gateways.clear();
    publishClients();
    if (wasListening) {
        tell(JournalKind::Off, m_sentences.stopped());
    }
}

void OpcFeed::admit()
{
    while (QTcpSocket *socket = m_server.nextPendingConnection()) {
        if (m_gateways.size() >= m_config.gateways) {
            if (!std::exchange(m_isFull, true)) {
                tell(JournalKind::Error, opcsentences::full(m_config.gateways));
            }
            delete socket;
            continue;
        }
        auto *gateway = new OpcGateway(socket, m_image, m_opening, m_config.pace, this);
        m_gateways.push_back(gateway);
        connect(gateway, &OpcGateway::greeted, this, &OpcFeed::onGreeted);
        connect(gateway, &OpcGateway::ended, this, [this, gateway](OpcGateway::End how) { onEnded(gateway, how); });
        if (m_diary.arrives(gateway->address(), SteadyTime::clock::now())) {
            tell(JournalKind::Info, m_sentences.came(gateway->address()));
        }
    }
}

/// A gateway that was registered with another list serves the present one and says so in OPCGate.TagsHashGood; so does the
/// journal, once for each such list.
void OpcFeed::onGreeted(const opclines::Greeting &greeting)
{
    if (greeting.registered == opcTagsHash(m_image.tags())) {
        return;
    }
    Q_EMIT otherListRegistered();
    if (!greeting.registered.isEmpty()
        && std::exchange(m_toldRegistration, greeting.registered) != greeting.registered) {
        tell(JournalKind::Error, opcsentences::oldRegistration());
    }
}

void OpcFeed::onEnded(OpcGateway *gateway, OpcGateway::End how)
{
    const QHostAddress address = gateway->address();
    remove(gateway);
    if (how == OpcGateway::End::Left) {
        return;
    }
    const bool isStalled = how == OpcGateway::End::Stalled;
    const ClientTrouble trouble = isStalled ? ClientTrouble::Stalled : ClientTrouble::Malformed;
    if (m_diary.isNews(trouble, address, SteadyTime::clock::now())) {
        tell(JournalKind::Error, isStalled ? opcsentences::stalled() : opcsentences::malformed());
    }
}

void OpcFeed::dismiss(const QHostAddress &address, quint16 port)
{
    const auto found = std::find_if(m_gateways.begin(), m_gateways.end(), [&address, port](const OpcGateway *gateway) {
        return gateway->port() == port && gateway->address() == address;
    });
    if (found != m_gateways.end()) {
        OpcGateway *gateway = *found;
        remove(gateway);
        gateway->leave();
        tell(JournalKind::Off, m_sentences.cutOff(address, port));
        publishClients();
    }
}

void OpcFeed::remove(OpcGateway *gateway)
{
    std::erase(m_gateways, gateway);
    m_isFull = false;
    m_diary.leaves(gateway->address(), SteadyTime::clock::now());
    gateway->deleteLater();
}

void OpcFeed::updateReadings(const QList<Reading> &batch)
{
    std::vector<int> changed;
    for (const Reading &reading : batch) {
        m_image.update(reading, changed);
    }
    pass(changed);
}

void OpcFeed::updateLine(const LineStatus &status)
{
    std::vector<int> changed;
    m_image.update(status, utcNow(), changed);
    pass(changed);
}

void OpcFeed::pass(const std::vector<int> &changed)
{
    if (changed.empty() || m_gateways.empty()) {
        return;
    }
    for (OpcGateway *gateway : m_gateways) {
        gateway->note(changed);
    }
    if (!m_gather.isActive()) {
        m_gather.start();
    }
}

void OpcFeed::lookAround()
{
    for (const ClientDiary::Departure &departure : m_diary.departures(SteadyTime::clock::now())) {
        const auto ago =
            std::chrono::duration_cast<std::chrono::microseconds>(SteadyTime::clock::now() - departure.left);
        tell(JournalKind::Info, m_sentences.gone(departure.address, utcNow() - ago));
    }
    publishClients();
}

void OpcFeed::publishClients()
{
    if (!m_hasPublished && m_gateways.empty()) {
        return;
    }
    m_hasPublished = !m_gateways.empty();
    QList<ClientInfo> clients;
    for (const OpcGateway *gateway : m_gateways) {
        clients.append(gateway->info());
    }
    Q_EMIT clientsChanged(clients);
}

void OpcFeed::tell(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, utcNow(), text});
}

} // namespace gorizont
