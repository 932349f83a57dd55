// What the page of trends is made of; how it behaves stands in trendspage.cpp.

#include "ui/plots/curvechooser.h"
#include "ui/plots/rangeactions.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QComboBox>
#include <QLabel>
#include <QSplitter>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

namespace gorizont {

void TrendsPage::build()
{
    m_tick = new QTimer(this);
    m_chooser = new CurveChooser(m_registry, this);
    m_plot = new TrendPlot(this);
    m_plot->setObjectName(QStringLiteral("trendPlot"));
    m_plot->setAccessibleName(tr("Trend"));
    m_hint = new QLabel(m_plot);
    m_hint->setObjectName(QStringLiteral("trendHint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto *over = new QVBoxLayout(m_plot);
    over->addWidget(m_hint, 1);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("trendState"));
    m_state->setContentsMargins(6, 2, 6, 2);
    auto *bar = new QToolBar(this);
    bar->setObjectName(QStringLiteral("trendBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    buildToolBar(bar);
    auto *columns = new QSplitter(Qt::Horizontal, this);
    columns->setObjectName(QStringLiteral("trendColumns"));
    columns->addWidget(m_chooser);
    columns->addWidget(m_plot);
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
    auto *units = new QComboBox(bar);
    units->setObjectName(QStringLiteral("tiltUnit"));
    units->setToolTip(tr("In what angles are drawn"));
    units->addItems({tr("degrees"), tr("arc-seconds")});
    bar->addWidget(units);
    connect(units, &QComboBox::activated, this, [this](int index) {
        setUnit(index == 0 ? TiltUnit::Degrees : TiltUnit::ArcSeconds);
    });
}

} // namespace gorizont
