#include "ui/mainwindow.h"

#include "ui/attentionbanner.h"
#include "ui/attentiondialog.h"
#include "ui/complaintsdialog.h"
#include "ui/infopanel.h"
#include "ui/models/icons.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"
#include "ui/sitetree.h"
#include "ui/statepanel.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>

#include <algorithm>

namespace gorizont {

namespace {

/// Nobody reads faster, and the tables of a large site cost a processor at TmUpdateInt (spec/traps.md).
constexpr std::chrono::milliseconds shortestRefresh(250);

} // namespace

MainWindow::MainWindow(
    SensorRegistry &registry, Journal &journal, AlarmWatch &alarms, const ServerConfig &config,
    const QList<Complaint> &complaints, QWidget *parent)
    : QMainWindow(parent)
    , m_registry(registry)
    , m_alarms(alarms)
    , m_config(config)
    , m_complaints(complaints)
    , m_refreshTimer(new QTimer(this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(config.caption);
    setWindowIcon(icons::program());
    buildPanels(journal);
    buildMenus();
    buildStatusBar();
    restoreLayout();

    m_refreshTimer->setObjectName(QStringLiteral("refreshTimer"));
    m_refreshTimer->setInterval(std::max(shortestRefresh, config.timing.updateInterval));
    connect(m_refreshTimer, &QTimer::timeout, this, &MainWindow::refresh);
    // One flag a batch, whatever its size: the values wait in the registry until somebody looks.
    connect(&registry, &SensorRegistry::readingsChanged, this, [this] { m_isDirty = true; });
    connect(&registry, &SensorRegistry::lineChanged, this, [this] { m_isDirty = true; });
    connect(m_tree, &SiteTree::selectionChanged, this, &MainWindow::showItem);
    connect(m_state, &StatePanel::chosen, this, &MainWindow::select);
    connect(m_state, &StatePanel::clientDismissed, this, &MainWindow::clientDismissed);
    connect(m_state, &StatePanel::wideChanged, this, &MainWindow::setWide);
    connect(m_banner, &AttentionBanner::listWanted, this, &MainWindow::showAttention);
    select(SiteItem::server());
    m_tree->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::showAtStart()
{
    if (!m_config.startsHidden) {
        show();
    } else if (!m_hidesToTray) {
        showMinimized();
    }
}

void MainWindow::select(SiteItem item)
{
    m_tree->select(item);
}

void MainWindow::showItem(SiteItem item)
{
    if (item.kind == SiteItem::Kind::Line) {
        m_lastLine = item.index;
    } else if (item.kind == SiteItem::Kind::Sensor) {
        m_lastSensor = item.index;
        m_lastLine = m_registry.sensors()[static_cast<std::size_t>(item.index)].line;
    }
    m_state->setItem(item);
    m_info->setItem(item);
}

void MainWindow::showInfoTab(int tab)
{
    m_state->leaveWidePage();
    m_info->setCurrentIndex(tab);
}

void MainWindow::setWide(bool isWide)
{
    if (isWide && m_rowsState.isEmpty()) {
        m_rowsState = m_rows->saveState();
        m_info->hide();
    } else if (!isWide && !m_rowsState.isEmpty()) {
        m_info->show();
        m_rows->restoreState(std::exchange(m_rowsState, {}));
    }
}

void MainWindow::goToPort()
{
    m_state->leaveWidePage();
    if (!m_registry.lines().empty()) {
        select(SiteItem::line(m_lastLine));
    }
}

/// The sensor selected last; after another port its first one.
void MainWindow::goToSensor()
{
    m_state->leaveWidePage();
    if (m_registry.sensors().empty()) {
        return;
    }
    const SiteItem item = m_tree->selected();
    if (item.kind == SiteItem::Kind::Line) {
        const std::vector<int> &sensors = m_registry.lines()[static_cast<std::size_t>(item.index)].sensors;
        if (!sensors.empty() && std::find(sensors.begin(), sensors.end(), m_lastSensor) == sensors.end()) {
            m_lastSensor = sensors.front();
        }
    }
    select(SiteItem::sensor(m_lastSensor));
}

void MainWindow::appendMeasurement(const QString &line)
{
    m_info->appendMeasurement(line);
}

void MainWindow::setServerStatus(const QString &text)
{
    m_server->setText(text);
}

void MainWindow::setClients(const QString &service, const QList<ClientInfo> &clients)
{
    m_state->setClients(service, clients);
    if (service == QStringLiteral("OPC DA")) {
        m_info->setGateways(static_cast<int>(clients.size()));
    }
}

void MainWindow::refresh()
{
    m_clock->setText(valuetext::clock(utcNow()));
    m_state->refresh(m_isDirty);
    if (m_isDirty) {
        m_isDirty = false;
        m_tree->refresh();
        m_counts->setText(statetext::counts(countHealth(m_registry)));
    }
}

void MainWindow::retry()
{
    Q_EMIT retryRequested();
    m_isDirty = true;
    refresh();
}

void MainWindow::updateRefreshing()
{
    const bool isSeen = isVisible() && !isMinimized();
    if (isSeen && !m_refreshTimer->isActive()) {
        m_refreshTimer->start();
        m_isDirty = true;
        refresh();
    } else if (!isSeen) {
        m_refreshTimer->stop();
    }
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    updateRefreshing();
    if (!m_complaints.isEmpty() && !isMinimized()) {
        QTimer::singleShot(0, this, &MainWindow::showComplaints);
    }
}

void MainWindow::hideEvent(QHideEvent *event)
{
    QMainWindow::hideEvent(event);
    updateRefreshing();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::WindowStateChange) {
        return;
    }
    updateRefreshing();
    if (isMinimized() && m_hidesToTray) {
        QTimer::singleShot(0, this, &QWidget::hide); // after the window manager has finished with the event
    }
}

void MainWindow::raiseWindow()
{
    setWindowState((windowState() & ~Qt::WindowMinimized) | Qt::WindowActive);
    show();
    raise();
    activateWindow();
}

void MainWindow::toggle()
{
    if (!isVisible() || isMinimized()) {
        raiseWindow();
    } else if (m_hidesToTray) {
        hide();
    } else {
        showMinimized();
    }
}

void MainWindow::endWithoutQuestion()
{
    m_isExitConfirmed = true;
    close();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    // The end of the desktop session does not wait for an answer.
    const bool mayEnd = m_config.closesSilently || m_isExitConfirmed || qGuiApp->isSavingSession();
    event->setAccepted(mayEnd);
    if (!mayEnd) {
        askExit();
        return;
    }
    saveLayout();
    Q_EMIT exitRequested();
}

/// Returns at once: the program may be told to end in another way while the question is open.
void MainWindow::askExit()
{
    if (m_exitQuestion) {
        m_exitQuestion->raise();
        return;
    }
    m_exitQuestion =
        new QMessageBox(QMessageBox::Question, windowTitle(), tr("End the work of the program?"), {}, this);
    m_exitQuestion->setObjectName(QStringLiteral("exitQuestion"));
    m_exitQuestion->setAttribute(Qt::WA_DeleteOnClose);
    m_exitQuestion->setInformativeText(tr("Polling of the sensors, records and the data server will stop."));
    QPushButton *yes = m_exitQuestion->addButton(tr("&Yes"), QMessageBox::YesRole);
    yes->setObjectName(QStringLiteral("exitYes"));
    QPushButton *no = m_exitQuestion->addButton(tr("&No"), QMessageBox::NoRole);
    no->setObjectName(QStringLiteral("exitNo"));
    m_exitQuestion->setDefaultButton(no);
    m_exitQuestion->setEscapeButton(no);
    connect(yes, &QPushButton::clicked, this, &MainWindow::endWithoutQuestion);
    m_exitQuestion->open();
}

void MainWindow::showAttention()
{
    if (!m_attention) {
        m_attention = new AttentionDialog(m_registry, m_alarms, this);
        connect(m_attention, &AttentionDialog::chosen, this, &MainWindow::select);
    }
    m_attention->show();
    m_attention->raise();
    m_attention->activateWindow();
}

void MainWindow::showComplaints()
{
    if (!m_complaints.isEmpty()) {
        (new ComplaintsDialog(std::exchange(m_complaints, {}), this))->show();
    }
}

} // namespace gorizont
