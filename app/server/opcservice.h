#pragma once

#include "app/server/opcsetup.h"
#include "core/opc/opcfeed.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"

#include <QThread>

namespace gorizont {

/// The parameters of the weather stations in \a lines as their drivers name them; reads the files of `ParFile{i}`.
OpcWeather opcWeatherOf(const QList<LineConfig> &lines);

/// OPC DA in the main program: the feed for gateways in the servers thread, and what the first run does. Main thread.
class OpcService : public QObject
{
    Q_OBJECT

public:
    struct Site
    {
        const ServerConfig &config;
        QString dataFolder;
        bool ownsDataFolder = true; ///< false: another copy keeps the list of tags there
        SensorRegistry &registry;
        Journal &journal;
        QThread &servers;
    };

    explicit OpcService(const Site &site);

    void dismiss(const QHostAddress &address, quint16 port);

Q_SIGNALS:
    void clientsChanged(const QList<gorizont::ClientInfo> &clients);
    /// What the first run has done, for a window.
    void firstRunDone(const QString &message);

private:
    OpcFeed m_feed;
    OpcSetup m_setup;
};

} // namespace gorizont
