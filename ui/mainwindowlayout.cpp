// What the main window is made of; how it behaves stands in mainwindow.cpp.

#include "ui/aboutdialog.h"
#include "ui/attentionbanner.h"
#include "ui/infopanel.h"
#include "ui/mainwindow.h"
#include "ui/pages/partlayout.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"
#include "ui/sitetree.h"
#include "ui/statepanel.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>

namespace gorizont {

namespace {

/// Where the window was, how it was divided, and the columns of its tables: nothing else is kept outside the ini.
QSettings windowSettings()
{
    const QString name = QStringLiteral("Gorizont Server");
    return QSettings(QSettings::NativeFormat, QSettings::UserScope, name, name);
}

} // namespace

void MainWindow::buildPanels(Journal &journal)
{
    m_tree = new SiteTree(m_registry, this);
    m_banner = new AttentionBanner(m_alarms, this);
    m_state = new StatePanel(m_registry, m_config.showsAdvanced, this);
    m_info = new InfoPanel(m_registry, journal, m_config, this);
    m_rows = new QSplitter(Qt::Vertical, this);
    m_rows->setObjectName(QStringLiteral("rowsSplitter"));
    m_rows->addWidget(m_state);
    m_rows->addWidget(m_info);
    m_rows->setChildrenCollapsible(false);
    m_rows->setStretchFactor(0, 3);
    m_rows->setStretchFactor(1, 2);
    auto *right = new QWidget(this);
    auto *layout = new QVBoxLayout(right);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_banner);
    layout->addWidget(m_rows, 1);
    m_columns = new QSplitter(Qt::Horizontal, this);
    m_columns->setObjectName(QStringLiteral("columnsSplitter"));
    m_columns->addWidget(m_tree);
    m_columns->addWidget(right);
    m_columns->setChildrenCollapsible(false);
    m_columns->setStretchFactor(0, 0);
    m_columns->setStretchFactor(1, 1);
    setCentralWidget(m_columns);
}

QAction *MainWindow::addGoAction(QMenu *menu, const QString &title, int digit, const std::function<void()> &go)
{
    QAction *action = menu->addAction(title, this, go);
    action->setObjectName(QStringLiteral("goAction%1").arg(digit));
    action->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(digit)));
    return action;
}

void MainWindow::buildMenus()
{
    QMenu *file = menuBar()->addMenu(tr("&File"));
    QAction *exit = file->addAction(tr("E&xit"), this, &QWidget::close);
    exit->setObjectName(QStringLiteral("exitAction"));
    exit->setShortcut(QKeySequence(QStringLiteral("Ctrl+Q")));

    buildViewMenu();

    QMenu *help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("Modbus &register map…"), this, &MainWindow::registerMapRequested)
        ->setObjectName(QStringLiteral("registerMapAction"));
    if (m_config.servesOpc) {
        help->addAction(tr("&OPC DA tags…"), this, &MainWindow::opcTagsRequested)
            ->setObjectName(QStringLiteral("opcTagsAction"));
    }
    QAction *about = help->addAction(tr("&About"), this, [this] { showAbout(this); });
    about->setObjectName(QStringLiteral("aboutAction"));
}

void MainWindow::buildViewMenu()
{
    m_view = menuBar()->addMenu(tr("&View"));
    QMenu *const view = m_view;
    addGoAction(view, tr("&Ports"), 1, [this] {
        select(SiteItem::server());
        m_state->showPorts();
    });
    addGoAction(view, tr("&Sensors"), 2, [this] {
        select(SiteItem::server());
        m_state->showSensors();
    });
    if (m_config.showsAdvanced) {
        addGoAction(view, tr("C&lients"), 9, [this] {
            select(SiteItem::server());
            m_state->showClients();
        });
    }
    addGoAction(view, tr("P&ort"), 3, [this] { goToPort(); });
    addGoAction(view, tr("S&ensor"), 4, [this] { goToSensor(); });
    m_endOfPages = view->addSeparator();
    addGoAction(view, tr("Se&ttings"), 5, [this] { showInfoTab(0); });
    addGoAction(view, tr("&Measurements"), 6, [this] { showInfoTab(1); });
    addGoAction(view, tr("&Journal"), 7, [this] { showInfoTab(2); });
    addGoAction(view, tr("Messages for the &dispatcher"), 8, [this] { showAttention(); });
    view->addSeparator();
    QAction *find = view->addAction(tr("&Find a sensor"), m_tree, &SiteTree::startSearch);
    find->setObjectName(QStringLiteral("findAction"));
    find->setShortcut(QKeySequence::Find);
    QAction *refresh = view->addAction(tr("&Refresh"), this, &MainWindow::retry);
    refresh->setObjectName(QStringLiteral("refreshAction"));
    refresh->setShortcut(QKeySequence(Qt::Key_F5));
    QAction *restore = view->addAction(tr("Restore &columns"), this, &MainWindow::restoreColumns);
    restore->setObjectName(QStringLiteral("restoreAllColumnsAction"));
}

void MainWindow::addWidePage(QWidget *page, const QString &title, const QKeySequence &key)
{
    m_state->addWidePage(page, title);
    const QSettings settings = windowSettings();
    restoreTables(settings, *page);
    restoreSplitters(settings, *page);
    auto *action = new QAction(title, this);
    action->setObjectName(page->objectName() + QStringLiteral("Action"));
    action->setShortcut(key);
    connect(action, &QAction::triggered, m_state, [this, page] { m_state->showWidePage(page); });
    m_view->insertAction(m_endOfPages, action);
}

int MainWindow::selectedLine() const
{
    const SiteItem item = m_tree->selected();
    switch (item.kind) {
    case SiteItem::Kind::Line: return item.index;
    case SiteItem::Kind::Sensor: return m_registry.sensors()[static_cast<std::size_t>(item.index)].line;
    case SiteItem::Kind::Server: break;
    }
    return -1;
}

void MainWindow::offerService(const WorkerOfPort &worker, Journal &journal, const KeepRecords &keep)
{
    m_service = std::make_unique<ServiceDesk>(m_config, m_registry, journal, worker, keep, this);
    if (!m_service->isOffered()) {
        return;
    }
    auto *menu = new QMenu(tr("&Service"), this);
    menu->setObjectName(QStringLiteral("serviceMenu"));
    menuBar()->insertMenu(menuBar()->actions().constLast(), menu);
    m_service->fill(menu, selectedLine());
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { m_service->fill(menu, selectedLine()); });
    connect(m_tree, &SiteTree::menuWanted, this, [this](SiteItem item, const QPoint &position) {
        if (item.kind == SiteItem::Kind::Line) {
            m_service->showMenu(item.index, position);
        }
    });
}

void MainWindow::buildStatusBar()
{
    m_counts = new QLabel(this);
    m_counts->setObjectName(QStringLiteral("sensorCounts"));
    m_server = new QLabel(this);
    m_server->setObjectName(QStringLiteral("serverStatus"));
    m_clock = new QLabel(this);
    m_clock->setObjectName(QStringLiteral("clock"));
    for (QLabel *label : {m_counts, m_server, m_clock}) {
        label->setContentsMargins(6, 0, 6, 0);
    }
    statusBar()->addWidget(m_counts, 1);
    statusBar()->addPermanentWidget(m_server);
    statusBar()->addPermanentWidget(m_clock);
}

/// In the middle of the screen, with room for the frame of the window manager, which nobody knows before the window is shown.
void MainWindow::placeInSight()
{
    const QSize frame(20, 50);
    const QRect available = screen()->availableGeometry();
    resize(QSize(1340, 800).boundedTo(available.size() - frame));
    move(
        available.topLeft()
        + QPoint(available.width() - width() - frame.width(), available.height() - height() - frame.height()) / 2);
}

void MainWindow::restoreLayout()
{
    placeInSight();
    m_columns->setSizes({310, 1030});
    m_rows->setSizes({460, 280});
    const QSettings settings = windowSettings();
    // A screen that is smaller now, or scaled, must not hide a part of the window.
    if (restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray()) && !isMaximized()
        && !screen()->availableVirtualGeometry().contains(geometry())) {
        placeInSight();
    }
    m_columns->restoreState(settings.value(QStringLiteral("window/columns")).toByteArray());
    m_rows->restoreState(settings.value(QStringLiteral("window/rows")).toByteArray());
    m_state->showServerTab(settings.value(QStringLiteral("window/serverTab")).toInt());
    m_info->setCurrentIndex(settings.value(QStringLiteral("window/infoTab")).toInt());
    restoreTables(settings, *this);
}

void MainWindow::saveLayout() const
{
    QSettings settings = windowSettings();
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/columns"), m_columns->saveState());
    settings.setValue(QStringLiteral("window/rows"), m_rowsState.isEmpty() ? m_rows->saveState() : m_rowsState);
    settings.setValue(QStringLiteral("window/serverTab"), m_state->serverTab());
    settings.setValue(QStringLiteral("window/infoTab"), m_info->currentIndex());
    keepTables(settings, *this);
    for (const QWidget *page : m_state->widePages()) {
        keepSplitters(settings, *page);
    }
}

void MainWindow::restoreColumns()
{
    for (const TableView *table : findChildren<TableView *>()) {
        table->columns().restore();
    }
}

} // namespace gorizont
