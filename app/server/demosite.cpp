#include "app/server/demosite.h"

#ifdef Q_OS_UNIX

#include "app/ptyport.h"

#include <QTemporaryDir>
#include <QThread>

namespace gorizont {

struct DemoSite::Ports
{
    QTemporaryDir folder;
    QThread thread;
    std::vector<std::unique_ptr<PtyPort>> list;
};

DemoSite::DemoSite(QList<LineConfig> &lines)
    : m_ports(std::make_unique<Ports>())
{
    m_ports->thread.setObjectName(QStringLiteral("demo site"));
    for (LineConfig &line : lines) {
        auto port = std::make_unique<PtyPort>(line, SimulatedBus::Options(), m_ports->folder.path());
        port->moveToThread(&m_ports->thread);
        line.device = port->linkPath();
        QObject::connect(&m_ports->thread, &QThread::started, port.get(), &PtyPort::plug);
        QObject::connect(&m_ports->thread, &QThread::finished, port.get(), &PtyPort::unplug, Qt::DirectConnection);
        m_ports->list.push_back(std::move(port));
    }
    m_ports->thread.start();
}

DemoSite::~DemoSite()
{
    m_ports->thread.quit();
    m_ports->thread.wait();
}

} // namespace gorizont

#else

namespace gorizont {

struct DemoSite::Ports
{
};

DemoSite::DemoSite(QList<LineConfig> &lines)
{
    for (LineConfig &line : lines) {
        line.device = QStringLiteral("sim:");
    }
}

DemoSite::~DemoSite() = default;

} // namespace gorizont

#endif
