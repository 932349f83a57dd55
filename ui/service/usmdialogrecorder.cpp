// The recorder mode in the service window of УСМ-ИСН.

#include "ui/service/servicetext.h"
#include "ui/service/usmdialog.h"
#include "ui/service/usmform.h"
#include "ui/service/usmrecorderpanel.h"
#include "ui/service/usmtext.h"

#include <QDateTime>
#include <QTimer>

namespace gorizont {

using namespace usmisn;

namespace {

constexpr int mostWakings = static_cast<int>(Service::stopLimit / Service::repeatStop);

} // namespace

void UsmDialog::askStart()
{
    const Recording recording = m_form->recorder()->recording(QDateTime::currentSecsSinceEpoch());
    if (!isPossible(recording)) {
        say(tr("The first measurement has to lie in the future. Nothing was sent."));
        return;
    }
    const QString how =
        tr("It sleeps, measures every %1 s and answers nobody until it is woken here, which takes up to two "
           "minutes, or is without power for more than a minute.")
            .arg(recording.period.count());
    const bool isForAll = m_form->recorder()->isForAll();
    const QString question = isForAll ? tr("Make ALL devices of the УСМ series on this line recorders?")
                                      : tr("Make sensor %1 a recorder?").arg(address());
    confirm(question + u' ' + how, tr("&Begin"), [this, isForAll, recording] {
        Recording now = recording;
        now.now = QDateTime::currentSecsSinceEpoch(); // the question may have stood for a while
        if (isForAll) {
            tellAll(tr("recorder mode"), [now](const Service &service, Line &line) {
                return service.startEveryCycle(line, now);
            });
        } else {
            startCycle(now);
        }
    });
}

void UsmDialog::startCycle(const Recording &recording)
{
    if (!isReady()) { // lost while the question was open
        return;
    }
    const int to = address();
    beginWork(tr("recorder mode"));
    say(tr("Writing: %1…").arg(tr("recorder mode")));
    run([service = m_service, to, recording](Line &line) { return service.startCycle(line, to, recording); },
        [this, to](const Result<void> &started) {
            const QString text = usmtext::startOutcome(started);
            note(started ? JournalKind::Info : JournalKind::Error, to, text);
            say(tr("Sensor %1: %2").arg(to).arg(text));
            if (started) {
                m_identity.reset(); // it does not answer any more
            }
            endWork(bool(started));
        });
}

void UsmDialog::wake()
{
    if (begin(Task::Wake)) {
        m_wakeAddress = m_form->recorder()->isForAll() ? everybody : m_form->recorder()->wakeAddress();
        m_wakeAttempts = 0;
        m_isWakingStopped = false;
        wakeNext();
    }
}

/// A recorder listens for one second in 26 (in another place of the manual, in 60): it is asked again and again.
void UsmDialog::wakeNext()
{
    m_form->recorder()->showWaking(100 * m_wakeAttempts / mostWakings);
    updateControls();
    say(m_wakeAddress == everybody ? tr("Every recorder on the line is being woken; nobody answers that…")
                                   : tr("Waiting until recorder %1 listens…").arg(m_wakeAddress));
    run([service = m_service, to = m_wakeAddress](
            Line &line) { return to == everybody ? service.stopEveryCycle(line) : service.tryStopCycle(line, to); },
        [this](const Result<void> &stopped) { onWakeTried(stopped); });
}

void UsmDialog::onWakeTried(const Result<void> &stopped)
{
    const bool isForAll = m_wakeAddress == everybody;
    const bool isOver = ++m_wakeAttempts >= mostWakings;
    if (stopped && !isForAll) {
        endWaking(tr("it does not record any more"), true);
    } else if (!isInService() || (!stopped && !isWorthAnother(stopped.fault()))) {
        endWaking(stopped ? QString() : servicetext::fault(stopped.fault()), false);
    } else if (m_isWakingStopped) {
        endWaking(tr("waking was stopped; it may still record"), false);
    } else if (isOver) {
        endWaking(
            isForAll ? tr("StopCycle was sent for two minutes. Scan the line.")
                     : tr("it did not answer for two minutes. Check its address and power; more than a minute without "
                          "power ends the recorder mode too"),
            isForAll);
    } else if (isForAll) {
        QTimer::singleShot(m_pauses.betweenStops, this, [this] {
            if (isGoingOn(Task::Wake)) {
                wakeNext();
            }
        });
    } else {
        wakeNext();
    }
}

void UsmDialog::endWaking(const QString &text, bool isAwake)
{
    const int from = m_wakeAddress;
    const QString report = from == everybody ? text : tr("Sensor %1: %2").arg(from).arg(text);
    note(isAwake ? JournalKind::Info : JournalKind::Error, from, text);
    m_form->recorder()->showWaking({});
    end();
    say(report);
    if (isAwake && from != everybody && isInService()) {
        m_before = report;
        showFoundAt(from);
    }
}

} // namespace gorizont
