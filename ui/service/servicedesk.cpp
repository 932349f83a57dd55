#include "ui/service/servicedesk.h"

#include "ui/service/and3dialog.h"
#include "ui/service/ind3dialog.h"
#include "ui/service/mk14dialog.h"
#include "ui/service/servicetext.h"
#include "ui/service/usmdialog.h"
#include "ui/service/vimsdialog.h"

#include <QAction>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

constexpr std::array serviced{
    SensorType::InD, SensorType::AnD3, SensorType::UsmIsn, SensorType::LVims, SensorType::Mk14};

QString objectNameOf(SensorType type)
{
    switch (type) {
    case SensorType::InD: return QStringLiteral("serviceInD3");
    case SensorType::UsmIsn: return QStringLiteral("serviceUsm");
    case SensorType::LVims: return QStringLiteral("serviceLVims");
    case SensorType::Mk14: return QStringLiteral("serviceMk14");
    default: break;
    }
    return QStringLiteral("serviceAnD3");
}

ServiceDialog *makeDialog(SensorType type, const ServicePort &port, QWidget *window)
{
    switch (type) {
    case SensorType::InD: return new Ind3Dialog(port, window);
    case SensorType::UsmIsn: return new UsmDialog(port, window);
    case SensorType::LVims: return new VimsDialog(port, window);
    case SensorType::Mk14: return new Mk14Dialog(port, window);
    default: break;
    }
    return new And3Dialog(port, window);
}

} // namespace

ServiceDesk::ServiceDesk(
    const ServerConfig &config, SensorRegistry &registry, Journal &journal, WorkerOfPort worker, KeepRecords keep,
    QWidget *window)
    : m_config(config)
    , m_registry(registry)
    , m_journal(journal)
    , m_worker(std::move(worker))
    , m_keep(std::move(keep))
    , m_window(window)
{
}

ServiceDesk::~ServiceDesk()
{
    for (const auto &entry : m_dialogs) {
        delete entry.second.data();
    }
}

void ServiceDesk::fill(QMenu *menu, int line)
{
    menu->clear();
    menu->setToolTipsVisible(true);
    for (const SensorType type : serviced) {
        addEntry(menu, type, line);
    }
}

void ServiceDesk::addEntry(QMenu *menu, SensorType type, int line)
{
    const QString port = line < 0 ? QString() : m_registry.lines()[static_cast<std::size_t>(line)].config.title();
    const QString why = objection(type, line);
    QAction *action =
        menu->addAction(servicetext::menuTitle(type, port), this, [this, type, line] { open(type, line); });
    action->setObjectName(objectNameOf(type));
    action->setEnabled(why.isEmpty());
    action->setToolTip(why);
    action->setStatusTip(why);
}

void ServiceDesk::showMenu(int line, const QPoint &position)
{
    if (!isOffered()) {
        return;
    }
    auto *menu = new QMenu(m_window);
    menu->setObjectName(QStringLiteral("portMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fill(menu, line);
    menu->popup(position);
}

QString ServiceDesk::objection(SensorType type, int line) const
{
    if (line < 0) {
        return tr("Select a port in the tree first.");
    }
    const SensorRegistry::Line &port = m_registry.lines()[static_cast<std::size_t>(line)];
    if (dialog(type, port.config.index)) {
        return {}; // it is raised
    }
    if (!port.config.isOn || !m_worker(port.config.index)) {
        return tr("The port is off (On=0).");
    }
    if (port.status.state == LineState::Service) {
        return tr("The port is in service already.");
    }
    if (port.status.state != LineState::Open) {
        return tr("The port is not open.");
    }
    const auto isIt = [type](const SensorConfig &sensor) { return sensor.type == type; };
    const QList<SensorConfig> &sensors = port.config.sensors;
    if (type != SensorType::AnD3 && std::none_of(sensors.begin(), sensors.end(), isIt)) {
        return tr("There is no %1 in the list of this port.").arg(servicetext::deviceName(type));
    }
    return {};
}

ServiceDialog *ServiceDesk::dialog(SensorType type, int port) const
{
    const auto found = m_dialogs.find({type, port});
    return found != m_dialogs.end() && found->second && found->second->isVisible() ? found->second.data() : nullptr;
}

void ServiceDesk::open(SensorType type, int line)
{
    if (!objection(type, line).isEmpty()) {
        return;
    }
    if (ServiceDialog *open = dialog(type, m_registry.lines()[static_cast<std::size_t>(line)].config.index)) {
        open->raise();
        open->activateWindow();
    } else {
        warn(type, line);
    }
}

void ServiceDesk::warn(SensorType type, int line)
{
    if (m_warning) {
        m_warning->raise();
        return;
    }
    const QString title = m_registry.lines()[static_cast<std::size_t>(line)].config.title();
    m_warning = new QMessageBox(
        QMessageBox::Warning, servicetext::menuTitle(type, title),
        tr("%1 goes into service mode: the monitoring of all its sensors is suspended.").arg(title),
        QMessageBox::NoButton, m_window);
    m_warning->setObjectName(QStringLiteral("serviceWarning"));
    m_warning->setAttribute(Qt::WA_DeleteOnClose);
    m_warning->setInformativeText(tr("Until the service window is closed, screens, files and clients keep the last "
                                     "values, marked as not valid. The other ports go on."));
    QPushButton *ok = m_warning->addButton(tr("&OK"), QMessageBox::AcceptRole);
    ok->setObjectName(QStringLiteral("warningOk"));
    QPushButton *cancel = m_warning->addButton(tr("&Cancel"), QMessageBox::RejectRole);
    cancel->setObjectName(QStringLiteral("warningCancel"));
    m_warning->setDefaultButton(ok);
    m_warning->setEscapeButton(cancel);
    connect(ok, &QPushButton::clicked, this, [this, type, line] { openDialog(type, line); });
    m_warning->open();
}

void ServiceDesk::openDialog(SensorType type, int line)
{
    const LineConfig &config = m_registry.lines()[static_cast<std::size_t>(line)].config;
    LineWorker *worker = m_worker(config.index);
    if (!worker) {
        return;
    }
    ServiceDialog *dialog =
        makeDialog(type, {config, m_config.timing, *worker, m_registry, m_journal, m_keep}, m_window);
    m_dialogs[{type, config.index}] = dialog;
    dialog->show();
    dialog->enter();
}

} // namespace gorizont
