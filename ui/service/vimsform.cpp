#include "ui/service/vimsform.h"

#include "ui/service/vimscomparison.h"
#include "ui/service/vimsmodulepanel.h"
#include "ui/service/vimssettingspanel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>

namespace gorizont {

namespace {

constexpr int comparisonTab = 2;

} // namespace

VimsForm::VimsForm(QComboBox *modules, QWidget *parent)
    : QWidget(parent)
    , m_modules(modules)
    , m_tabs(new QTabWidget(this))
    , m_module(new VimsModulePanel(m_tabs))
    , m_settings(new VimsSettingsPanel(m_tabs))
    , m_comparison(new VimsComparison(m_tabs))
    , m_progress(new QProgressBar(this))
{
    m_modules->setParent(this);
    m_modules->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto *label = new QLabel(tr("&Module:"), this);
    label->setBuddy(m_modules);
    m_tabs->setObjectName(QStringLiteral("vimsTabs"));
    m_tabs->addTab(m_module, tr("Module"));
    m_tabs->addTab(m_settings, tr("Settings"));
    m_tabs->addTab(m_comparison, QString());
    m_progress->setObjectName(QStringLiteral("settingsProgress"));
    m_progress->setTextVisible(false);
    QSizePolicy keepsItsPlace = m_progress->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsItsPlace);
    auto *top = new QHBoxLayout;
    top->addWidget(label);
    top->addWidget(m_modules);
    top->addWidget(m_progress, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(m_tabs, 1);
    layout->addWidget(makeButtons());
    setFocusProxy(m_tabs);
    compare({}, {});
    showProgress(0, 0);
}

QPushButton *VimsForm::addButton(
    const QString &text, const char *name, const QString &toolTip, void (VimsForm::*wanted)())
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(toolTip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, wanted);
    m_buttons.append(button);
    return button;
}

/// From the form to the module in the order in which it is done; below, the ways back.
QWidget *VimsForm::makeButtons()
{
    auto *box = new QWidget(this);
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    m_read = addButton(
        tr("Rea&d"), "readSettings", tr("Reads all settings again, those in use and those prepared."),
        &VimsForm::readWanted);
    m_write = addButton(
        tr("&Write…"), "writeSettings", tr("Prepares what was changed here (MUT). The module does not use it yet."),
        &VimsForm::writeWanted);
    addButton(
        tr("&Apply…"), "applySettings", tr("The module uses the prepared settings until its next start."),
        &VimsForm::applyWanted);
    addButton(
        tr("&Keep in flash…"), "flashSettings", tr("The module starts with the prepared settings from now on."),
        &VimsForm::flashWanted);
    addButton(
        tr("&From a file…"), "openSettings", tr("Fills the form from a backup. Nothing is written yet."),
        &VimsForm::openWanted);
    addButton(tr("&To a file…"), "saveSettings", tr("Keeps the settings in use as a backup."), &VimsForm::saveWanted);
    addButton(
        tr("Reload from flas&h…"), "reloadSettings",
        tr("The module uses the settings of its flash again; what was only applied is lost."), &VimsForm::reloadWanted);
    for (int i = 0; i < m_buttons.size(); ++i) {
        grid->addWidget(m_buttons.at(i), i / 4, i % 4);
    }
    return box;
}

void VimsForm::compare(const QList<quint16> &inUse, const QList<quint16> &prepared)
{
    m_comparison->compare(inUse, prepared, m_settings->wanted());
    m_tabs->setTabText(comparisonTab, tr("Differences (%1)").arg(m_comparison->differences()));
}

void VimsForm::setControls(const Controls &controls)
{
    const bool isKnown = controls.isFree && controls.isKnown;
    m_module->setMayRestart(controls.isFree);
    m_settings->setEditable(isKnown);
    for (QPushButton *button : m_buttons) {
        button->setEnabled(isKnown);
    }
    m_read->setEnabled(controls.isFree);
    m_write->setEnabled(isKnown && controls.isEdited && m_settings->complaint().isEmpty());
}

void VimsForm::showProgress(qsizetype done, qsizetype total)
{
    m_progress->setRange(0, std::max(1, static_cast<int>(total)));
    m_progress->setValue(static_cast<int>(done));
    m_progress->setVisible(total > 0);
}

QWidgetList VimsForm::tabOrder() const
{
    QWidgetList order{m_modules, m_tabs};
    order += m_module->tabOrder() + m_settings->tabOrder() + m_comparison->tabOrder();
    for (QPushButton *button : m_buttons) {
        order << button;
    }
    return order;
}

} // namespace gorizont
