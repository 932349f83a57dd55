#pragma once

#include "core/config/serverconfig.h"
#include "core/net/clientdiary.h"
#include "core/net/desksentences.h"
#include "core/opc/opcgateway.h"
#include "core/values/journalentry.h"

#include <QTcpServer>

#include <optional>

namespace gorizont {

struct OpcFeedConfig
{
    int port = 43212; ///< [OPC] Port; 0: any free one
    QString caption; ///< Caption, for the gateway
    QList<LineConfig> lines;
    OpcWeather weather;
    std::size_t gateways = 16; ///< connections at a time
    std::chrono::milliseconds retry{5000}; ///< between two attempts to take the port
    std::chrono::milliseconds gather{50}; ///< changes are sent together
    OpcGateway::Pace pace;
};

OpcFeedConfig opcFeedConfig(const ServerConfig &config, const OpcWeather &weather);

/// Feeds the gateways of OPC DA on this computer: tags, then every change (opclines.h). Servers thread.
/// Sockets of Qt and no descriptors, because the gateway is a program for Windows.
class OpcFeed : public QObject
{
    Q_OBJECT

public:
    explicit OpcFeed(const OpcFeedConfig &config, QObject *parent = nullptr);
    ~OpcFeed() override;

    static QString service() { return QStringLiteral("OPC DA"); } ///< as the clients page calls it
    const QList<OpcTag> &tags() const { return m_image.tags(); }
    quint16 port() const { return m_server.serverPort(); } ///< 0: not listening

public Q_SLOTS:
    void start();
    /// Tells every gateway that the program ends.
    void stop();
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);
    /// Cuts off one gateway; nothing happens when it has gone meanwhile.
    void dismiss(const QHostAddress &address, quint16 port);

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);
    void listening(quint16 port);
    /// A gateway came that was registered with another list of tags, or with none.
    void otherListRegistered();
    /// Once a second while somebody is connected, and once after the last one left.
    void clientsChanged(const QList<gorizont::ClientInfo> &clients);

private:
    void tryToListen();
    void admit();
    void onGreeted(const opclines::Greeting &greeting);
    void onEnded(OpcGateway *gateway, OpcGateway::End how);
    void remove(OpcGateway *gateway);
    void pass(const std::vector<int> &changed);
    void lookAround();
    void publishClients();
    void tell(JournalKind kind, const QString &text);

    const OpcFeedConfig m_config;
    OpcImage m_image;
    const OpcOpening m_opening;
    const DeskSentences m_sentences;
    ClientDiary m_diary;
    QTcpServer m_server;
    QTimer m_retry;
    QTimer m_gather; ///< runs from the first change until they are sent
    QTimer m_round; ///< once a second
    std::optional<QAbstractSocket::SocketError> m_toldError; ///< why the port is not served
    std::vector<OpcGateway *> m_gateways; ///< children, in the order they came
    QByteArray m_toldRegistration; ///< an old list that the journal was told of
    bool m_isFull = false; ///< the journal was told
    bool m_hasPublished = false; ///< the last clientsChanged() was not empty
};

} // namespace gorizont
