#include "ui/service/vimsmodulepanel.h"

#include "ui/service/valuelabel.h"
#include "ui/service/vimstext.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QPushButton>

namespace gorizont {

VimsModulePanel::VimsModulePanel(QWidget *parent)
    : QWidget(parent)
    , m_restart(new QPushButton(tr("&Restart the module…"), this))
{
    auto *group = new QGroupBox(tr("About the module"), this);
    auto *grid = new QGridLayout(group);
    const auto add = [&](const QString &title, const char *name, const QString &widest) {
        QLabel *label = valueLabel(QLatin1String(name), widest, group);
        const int row = grid->rowCount();
        grid->addWidget(new QLabel(title, group), row, 0);
        grid->addWidget(label, row, 1);
        return label;
    };
    const QString longest = QString(16, u'0');
    m_name = add(tr("Name of the device:"), "moduleName", longest);
    m_serial = add(tr("Serial number:"), "moduleSerial", longest);
    m_firmware = add(tr("Program:"), "moduleFirmware", longest);
    m_board = add(tr("Revision of the board:"), "moduleBoard", longest);
    m_mode = add(tr("Mode:"), "moduleMode", vimstext::mode(lvims::bootLoaderMode));
    m_writeError = add(tr("Error of the last write (LAST_WR_ERROR):"), "writeError", vimstext::error(4294967295U));
    m_settingsError =
        add(tr("Error of the settings (LAST_CHECK_SETTINGS_ERR):"), "settingsError", vimstext::error(4294967295U));
    grid->setColumnStretch(1, 1);
    m_restart->setObjectName(QStringLiteral("restartModule"));
    m_restart->setAutoDefault(false);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(group);
    layout->addWidget(m_restart, 0, Qt::AlignTrailing);
    layout->addStretch(1);
    connect(m_restart, &QPushButton::clicked, this, &VimsModulePanel::restartWanted);
    clear();
}

void VimsModulePanel::clear()
{
    for (QLabel *label : {m_name, m_serial, m_firmware, m_board, m_mode, m_writeError, m_settingsError}) {
        label->setText(QStringLiteral("—"));
    }
}

void VimsModulePanel::showIdentity(const lvims::Identity &identity)
{
    const auto set = [](QLabel *label, const QString &text) {
        label->setText(text.isEmpty() ? QStringLiteral("—") : text);
    };
    set(m_name, identity.name);
    set(m_serial, identity.serial);
    set(m_firmware, identity.firmware);
    set(m_board, identity.board);
    set(m_mode, vimstext::mode(identity.mode));
    showErrors(lvims::SettingErrors(identity.writeError, identity.settingsError));
}

void VimsModulePanel::showErrors(const lvims::SettingErrors &errors)
{
    m_writeError->setText(vimstext::error(errors.first));
    m_settingsError->setText(vimstext::error(errors.second));
}

void VimsModulePanel::setMayRestart(bool mayRestart)
{
    m_restart->setEnabled(mayRestart);
}

QWidgetList VimsModulePanel::tabOrder() const
{
    return {m_restart};
}

} // namespace gorizont
