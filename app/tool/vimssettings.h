#pragma once

#include "app/tool/vimsrun.h"

namespace gorizont::tool {

/// `gorizont-tool vims settings`, `reload` and `reboot`. What changes the module asks first.
class VimsSettings
{
public:
    explicit VimsSettings(const VimsRun &run);

    ExitCode settings(); ///< what its options say
    ExitCode reload();
    ExitCode reboot();

private:
    ExitCode show();
    ExitCode save();
    ExitCode load();
    ExitCode edit();
    Result<void> write(const QList<quint16> &prepared, const QList<quint16> &wanted, bool cutsOff);
    Result<void> checked(const Result<void> &written, bool isCommand = true);
    ExitCode fail(Fault fault, QJsonObject outcome) const;
    QJsonObject outcome(const QString &setting, bool isDone) const;
    void tell(const QString &text, const QJsonObject &outcome) const;

    const VimsRun &m_run;
    lvims::Service m_service;
    lvims::SettingErrors m_errors{0, 0}; ///< read last
};

} // namespace gorizont::tool
