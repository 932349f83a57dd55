// What the page of trends is made of; how it behaves stands in trendspage.cpp.

#include "ui/plots/cursorpair.h"
#include "ui/plots/cursorpanel.h"
#include "ui/plots/curvechooser.h"
#include "ui/plots/rangeactions.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace gorizont {

void TrendsPage::build()
{
    m_tick = new QTimer(this);
    m_chooser = new CurveChooser(m_registry, this);
    m_plot = new TrendPlot(this);
    m_plot->setObjectName(QStringLiteral("trendPlot"));
    m_plot->setAccessibleName(tr("Trend"));
    setFocusProxy(m_plot);
    m_hint = new QLabel(m_plot);
    m_hint->setObjectName(QStringLiteral("trendHint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_cursors = new CursorPair(m_plot);
    m_readout = new CursorPanel(this);
    m_readout->hide();
    setAcceptDrops(true);
    auto *over = new QVBoxLayout(m_plot);
    over->addWidget(m_hint, 1);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("trendState"));
    m_state->setContentsMargins(6, 2, 6, 2);
    auto *bar = new QToolBar(this);
    bar->setObjectName(QStringLiteral("trendBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    buildToolBar(bar);
    auto *rows = new QSplitter(Qt::Vertical, this);
    rows->setObjectName(QStringLiteral("trendRows"));
    rows->addWidget(m_plot);
    rows->addWidget(m_readout);
    rows->setStretchFactor(0, 1);
    rows->setStretchFactor(1, 0);
    rows->setSizes({500, 150});
    rows->setCollapsible(0, false);
    auto *columns = new QSplitter(Qt::Horizontal, this);
    columns->setObjectName(QStringLiteral("trendColumns"));
    columns->addWidget(m_chooser);
    columns->addWidget(rows);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setSizes({230, 800});
    columns->setChildrenCollapsible(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(columns, 1);
    layout->addWidget(m_state);
}

void TrendsPage::buildToolBar(QToolBar *bar)
{
    m_ranges = new RangeActions(this);
    bar->addActions(m_ranges->actions());
    m_now = bar->addAction(tr("Now"));
    m_now->setObjectName(QStringLiteral("followAction"));
    m_now->setCheckable(true);
    m_now->setToolTip(tr("The right end is the present moment and moves on with it (End)"));
    bar->addSeparator();
    QAction *cursors = bar->addAction(tr("Cursors"));
    cursors->setObjectName(QStringLiteral("cursorsAction"));
    cursors->setCheckable(true);
    cursors->setToolTip(
        tr("Two lines to read values, differences and slopes; drag them, or move A with Ctrl and B with Shift "
           "and the arrow keys"));
    connect(cursors, &QAction::toggled, this, &TrendsPage::showCursors);
    m_units = new QComboBox(bar);
    m_units->setObjectName(QStringLiteral("tiltUnit"));
    m_units->setToolTip(tr("In what angles are drawn"));
    m_units->addItems({tr("degrees"), tr("arc-seconds")});
    bar->addWidget(m_units);
    connect(m_units, &QComboBox::activated, this, [this](int index) {
        setUnit(index == 0 ? TiltUnit::Degrees : TiltUnit::ArcSeconds);
    });
    buildMenus(bar);
}

void TrendsPage::buildMenus(QToolBar *bar)
{
    const auto addMenu = [this, bar](const QString &title, const char *objectName) {
        auto *button = new QToolButton(bar);
        button->setText(title);
        button->setPopupMode(QToolButton::InstantPopup);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        auto *menu = new QMenu(button);
        menu->setObjectName(QLatin1String(objectName));
        button->setMenu(menu);
        bar->addWidget(button);
        return menu;
    };
    QMenu *layouts = addMenu(tr("Layouts"), "layoutsMenu");
    connect(layouts, &QMenu::aboutToShow, this, [this, layouts] { fillLayouts(layouts); });
    QMenu *files = addMenu(tr("Files"), "exportMenu");
    m_archive = bar->addAction(tr("Back to the archive"), this, &TrendsPage::closeOldFiles);
    m_archive->setObjectName(QStringLiteral("archiveAction"));
    m_archive->setVisible(false);
    files->addAction(tr("&Picture (PNG)…"), this, [this] { askExport(Export::Png); });
    files->addAction(tr("&Document (PDF)…"), this, [this] { askExport(Export::Pdf); });
    files->addAction(tr("Table for &Excel (CSV)…"), this, [this] { askExport(Export::ExcelCsv); });
    files->addAction(tr("Table for p&rograms (CSV, ISO 8601)…"), this, [this] { askExport(Export::IsoCsv); });
    files->addSeparator();
    files->addAction(tr("&Open old files…"), this, &TrendsPage::askOldFiles);
}

} // namespace gorizont
