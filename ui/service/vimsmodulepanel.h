#pragma once

#include "core/devices/lvims/lvimsservice.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace gorizont {

/// What a module is, and the registers in which it says what it did not like. GUI thread.
class VimsModulePanel : public QWidget
{
    Q_OBJECT

public:
    explicit VimsModulePanel(QWidget *parent = nullptr);

    void clear();
    void showIdentity(const lvims::Identity &identity);
    void showErrors(const lvims::SettingErrors &errors);
    void setMayRestart(bool mayRestart);
    QWidgetList tabOrder() const;

Q_SIGNALS:
    void restartWanted();

private:
    QLabel *m_name;
    QLabel *m_serial;
    QLabel *m_firmware;
    QLabel *m_board;
    QLabel *m_mode;
    QLabel *m_writeError;
    QLabel *m_settingsError;
    QPushButton *m_restart;
};

} // namespace gorizont
