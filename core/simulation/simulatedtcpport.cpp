#include "core/simulation/simulatedtcpport.h"

#include "core/protocol/mbap.h"

#include <QTcpSocket>
#include <QUrl>

#include <algorithm>

namespace gorizont {

namespace {

/// On a network the bytes of a request take no time worth speaking of.
LineConfig withoutWire(LineConfig config)
{
    config.baudRate = 1'000'000'000;
    return config;
}

} // namespace

SimulatedTcpPort::SimulatedTcpPort(const LineConfig &config, const SimulatedBus::Options &options)
    : m_bus(withoutWire(config), options)
    , m_port(static_cast<quint16>(QUrl(config.device).port(0)))
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedTcpPort::sendDue);
    connect(&m_server, &QTcpServer::newConnection, this, &SimulatedTcpPort::onConnection);
}

SimulatedTcpPort::~SimulatedTcpPort()
{
    unplug();
}

bool SimulatedTcpPort::isOwn(const QString &device)
{
    const QUrl url(device);
    const bool isLocal = url.host() == QLatin1String("localhost") || QHostAddress(url.host()).isLoopback();
    return url.scheme() == QLatin1String("tcp") && isLocal;
}

bool SimulatedTcpPort::plug()
{
    const bool isListening = m_server.listen(QHostAddress::LocalHost, m_port);
    m_port = isListening ? m_server.serverPort() : m_port;
    return isListening;
}

void SimulatedTcpPort::unplug()
{
    m_server.close();
    dropClients();
}

void SimulatedTcpPort::dropClients()
{
    const QList<QTcpSocket *> clients = m_heard.keys();
    for (QTcpSocket *client : clients) {
        client->abort();
    }
}

SimulatedBus::Time SimulatedTcpPort::now() const
{
    return std::chrono::duration_cast<SimulatedBus::Time>(std::chrono::steady_clock::now() - m_started);
}

void SimulatedTcpPort::onConnection()
{
    while (QTcpSocket *client = m_server.nextPendingConnection()) {
        client->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        m_heard.insert(client, {});
        connect(client, &QTcpSocket::readyRead, this, [this, client] { onRequest(client); });
        connect(client, &QTcpSocket::disconnected, this, [this, client] { onDisconnected(client); });
    }
}

void SimulatedTcpPort::onDisconnected(QTcpSocket *client)
{
    m_heard.remove(client);
    m_arriving.removeIf([client](const Answer &answer) { return answer.client == client; });
    client->deleteLater();
}

void SimulatedTcpPort::onRequest(QTcpSocket *client)
{
    QByteArray heard = m_heard.value(client) + client->readAll();
    Scan found = scanMbap(heard);
    for (; found.state == Scan::State::Complete; found = scanMbap(heard)) {
        const QByteArray request = heard.left(found.length);
        heard.remove(0, found.length);
        for (const SimulatedBus::Piece &piece : m_bus.receive(request, now())) {
            m_arriving.append({client, piece});
        }
    }
    if (found.state == Scan::State::Damaged) {
        client->abort();
        return;
    }
    m_heard[client] = heard;
    std::stable_sort(m_arriving.begin(), m_arriving.end(), [](const Answer &a, const Answer &b) {
        return a.piece.at < b.piece.at;
    });
    sendDue();
    const auto &devices = m_bus.devices();
    if (std::any_of(devices.begin(), devices.end(), [](const auto &device) { return device->takeDisconnect(); })) {
        dropClients();
    }
}

void SimulatedTcpPort::sendDue()
{
    while (!m_arriving.isEmpty() && m_arriving.first().piece.at <= now()) {
        const Answer answer = m_arriving.takeFirst();
        answer.client->write(answer.piece.bytes);
        answer.client->flush();
    }
    if (!m_arriving.isEmpty()) {
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(m_arriving.first().piece.at - now());
        m_timer.start(std::max(wait, std::chrono::milliseconds(0)));
    }
}

} // namespace gorizont
