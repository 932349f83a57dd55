#include "app/server/opcservice.h"

namespace gorizont {

OpcService::OpcService(const Site &site)
    : m_feed(opcFeedConfig(site.config, {}))
    , m_setup(site.dataFolder, m_feed.tags())
{
    OpcFeed *feed = &m_feed;
    connect(&site.registry, &SensorRegistry::readingsChanged, feed, &OpcFeed::updateReadings, Qt::QueuedConnection);
    connect(&site.registry, &SensorRegistry::lineChanged, feed, &OpcFeed::updateLine, Qt::QueuedConnection);
    connect(feed, &OpcFeed::journal, &site.journal, &Journal::append);
    connect(feed, &OpcFeed::clientsChanged, this, &OpcService::clientsChanged);
    connect(&m_setup, &OpcSetup::journal, &site.journal, &Journal::append);
    connect(&m_setup, &OpcSetup::done, this, &OpcService::firstRunDone);
    if (site.ownsDataFolder) {
        connect(feed, &OpcFeed::listening, &m_setup, &OpcSetup::run);
        connect(feed, &OpcFeed::otherListRegistered, &m_setup, [this, port = site.config.opc.port] {
            m_setup.renew(port);
        });
    }
    feed->updateReadings(site.registry.readings());
    for (const LineStatus &status : site.registry.lineStatuses()) {
        feed->updateLine(status);
    }
    feed->moveToThread(&site.servers);
    connect(&site.servers, &QThread::started, feed, &OpcFeed::start);
    connect(&site.servers, &QThread::finished, feed, &OpcFeed::stop, Qt::DirectConnection);
}

void OpcService::dismiss(const QHostAddress &address, quint16 port)
{
    QMetaObject::invokeMethod(
        &m_feed, [feed = &m_feed, address, port] { feed->dismiss(address, port); }, Qt::QueuedConnection);
}

} // namespace gorizont
