// Address, port settings and silence in the service window of УСМ-ИСН.

#include "ui/service/servicetext.h"
#include "ui/service/usmdialog.h"
#include "ui/service/usmform.h"
#include "ui/service/usmsettingspanel.h"
#include "ui/service/usmtext.h"

#include <QTimer>

namespace gorizont {

using namespace usmisn;

void UsmDialog::askAddress()
{
    const int newAddress = m_form->settings()->newAddress();
    if (m_form->settings()->isForAll()) {
        confirm(
            tr("Give ALL devices of the УСМ series on this line the address %1? Several with one address cannot be "
               "asked "
               "any more. Go on only if there is just one.")
                .arg(newAddress),
            tr("&Write"), [this, newAddress] {
                tellAll(tr("new address %1").arg(newAddress), [newAddress](const Service &service, Line &line) {
                    return service.setEveryAddress(line, newAddress);
                });
            });
        return;
    }
    confirm(tr("Give sensor %1 the address %2?").arg(address()).arg(newAddress), tr("&Write"), [this, newAddress] {
        changeAddress(newAddress);
    });
}

void UsmDialog::changeAddress(int newAddress)
{
    if (!isReady() || newAddress == 0) { // lost while the question was open
        return;
    }
    const int from = address();
    const QString what = tr("new address %1").arg(newAddress);
    beginWork(what);
    say(tr("Writing: %1…").arg(what));
    run([service = m_service, from, newAddress](Line &line) { return service.changeAddress(line, from, newAddress); },
        [this, from, newAddress](const Result<void> &changed) { onAddressChanged(from, newAddress, changed); });
}

void UsmDialog::onAddressChanged(int from, int to, const Result<void> &changed)
{
    QString text = usmtext::addressOutcome(from, to, changed);
    if (changed) {
        text += QStringLiteral(". ") + servicetext::iniReminder(port().line, SensorType::UsmIsn, from, to);
        moveTo(to);
    } else {
        scan()->distrust();
    }
    note(changed ? JournalKind::Info : JournalKind::Error, from, text);
    const QString report = tr("Sensor %1: %2").arg(from).arg(text);
    say(report);
    const bool leaves = isLeaving();
    endWork(bool(changed));
    if (!leaves && isInService()) {
        read(report);
    }
}

void UsmDialog::askPort(bool isReset)
{
    const PortSettings wanted = isReset ? factoryPort : m_form->settings()->portSettings();
    const QString to = usmtext::port(wanted);
    if (m_form->settings()->isForAll()) {
        confirm(
            tr("Give ALL devices of the УСМ series on this line the port settings %1? None of them answers; this port "
               "does "
               "not hear them any more until its own settings follow.")
                .arg(to),
            tr("&Write"), [this, isReset, wanted, to] {
                tellAll(tr("port settings %1").arg(to), [isReset, wanted](const Service &service, Line &line) {
                    return isReset ? service.resetEveryPort(line) : service.setEveryPort(line, wanted);
                });
            });
        return;
    }
    confirm(
        tr("Give sensor %1 the port settings %2? This port does not hear it any more until its own settings follow.")
            .arg(address())
            .arg(to),
        tr("&Write"), [this, isReset, wanted] { changePort(isReset, wanted); });
}

/// Without a new reading: who answers at other settings is not heard here.
void UsmDialog::changePort(bool isReset, const PortSettings &wanted)
{
    if (!isReady()) { // lost while the question was open
        return;
    }
    const int to = address();
    const QString what = tr("port settings %1").arg(usmtext::port(wanted));
    beginWork(what);
    say(tr("Writing: %1…").arg(what));
    run(
        [service = m_service, to, isReset, wanted](Line &line) -> Result<PortChange> {
            return isReset ? service.resetPort(line, to) : service.changePort(line, to, wanted);
        },
        [this, to, wanted](const Result<PortChange> &tried) {
            const PortChange change = tried ? *tried : PortChange{tried.fault()};
            QString text = usmtext::portOutcome(change, wanted);
            if (change.result) {
                text += QStringLiteral(". ") + usmtext::portReminder(wanted, port().line.index);
            }
            note(change.result ? JournalKind::Info : JournalKind::Error, to, text);
            say(tr("Sensor %1: %2").arg(to).arg(text));
            endWork(bool(change.result));
        });
}

/// A broadcast is never answered: what became of it is seen by a scan.
void UsmDialog::tellAll(const QString &what, const std::function<Result<void>(const Service &, Line &)> &tell)
{
    if (!isReady()) { // lost while the question was open
        return;
    }
    beginWork(what);
    say(tr("Writing: %1…").arg(what));
    run([service = m_service, tell](Line &line) { return tell(service, line); },
        [this, what](const Result<void> &sent) {
            const QString text = sent ? tr("%1, sent to all devices; nobody answers that. Scan the line.").arg(what)
                                      : tr("%1, not sent: %2").arg(what, servicetext::fault(sent.fault()));
            note(sent ? JournalKind::Info : JournalKind::Error, everybody, text);
            say(text);
            scan()->distrust();
            endWork(bool(sent));
        });
}

void UsmDialog::keepSilent()
{
    if (begin(Task::Silence)) {
        say(tr("The line is silent, so that devices that hang restart…"));
        port().worker.keepSilent(std::chrono::ceil<std::chrono::seconds>(m_pauses.silence));
        m_silencePercent = 0;
        m_silence->start();
    }
}

void UsmDialog::countSilence()
{
    const bool goesOn = isGoingOn(Task::Silence);
    m_form->settings()->showSilence(++m_silencePercent);
    if (goesOn && m_silencePercent < 100) {
        return;
    }
    m_silence->stop();
    m_form->settings()->showSilence({});
    if (goesOn) {
        end();
        read(tr("The line was silent; devices that hung have restarted."));
    }
}

} // namespace gorizont
