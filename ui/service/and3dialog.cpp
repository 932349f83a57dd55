#include "ui/service/and3dialog.h"

#include "ui/service/and3form.h"
#include "ui/service/changetext.h"
#include "ui/service/servicetext.h"

#include <QComboBox>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <algorithm>

namespace gorizont {

using and3::AddressChange;
using and3::AddressStep;

And3Dialog::And3Dialog(const ServicePort &port, QWidget *parent, std::chrono::milliseconds restartTime)
    : ServiceDialog(SensorType::AnD3, port, parent)
    , m_form(new And3Form(addresses(), this))
    , m_restart(new QTimer(this))
{
    setObjectName(QStringLiteral("and3Dialog"));
    m_restart->setInterval(restartTime / 100);
    connect(m_restart, &QTimer::timeout, this, &And3Dialog::waitForRestart);
    connect(m_form, &And3Form::chosen, this, &And3Dialog::updateControls);
    connect(m_form, &And3Form::writeWanted, this, &And3Dialog::write);
    connect(m_form, &And3Form::resetWanted, this, [this] {
        const bool isExpected = m_stored && m_stored->from == address();
        confirm(
            isExpected ? QString()
                       : tr("Nothing was written that needs a reset. Restart sensor %1? Its memory of samples is lost.")
                             .arg(address()),
            tr("&Restart"), [this] { reset(); });
    });
    setUp(m_form, m_form->tabOrder());
}

ScanPanel::Probe And3Dialog::probe() const
{
    return [service = service()](Line &line, int address) { return service.probe(line, address); };
}

void And3Dialog::updateControls()
{
    const bool isShown = isReady() && m_form->isShown();
    const bool mayChoose = isShown && scan()->isComplete();
    m_form->setControls(mayChoose, mayChoose && m_form->newAddress() != 0, isShown);
}

QString And3Dialog::unfinished(bool isLeaving) const
{
    if (!isLeaving || !m_stored) {
        return {};
    }
    return m_stored->isReset
        ? tr("Sensor %1 restarts with its new address %2; nobody has seen it there yet. Leave all the same?")
              .arg(m_stored->from)
              .arg(m_stored->to)
        : tr("The new address %2 of sensor %1 is stored, but it holds only after a system reset. Leave without it?")
              .arg(m_stored->from)
              .arg(m_stored->to);
}

void And3Dialog::showSensor()
{
    const bool isToRead = address() != 0 && isInService();
    if (isToRead) {
        beginWork(); // first, so that the focus is remembered
    }
    m_form->clear();
    m_form->offer(port().line, scan()->free());
    m_form->showRestart({});
    if (!isToRead) {
        updateControls();
        return;
    }
    const QString before = std::exchange(m_outcome, {});
    say(before.isEmpty() ? tr("Reading sensor %1…").arg(address()) : before);
    run([service = service(), to = address()](Line &line) { return service.read(line, to); },
        [this, before, to = address()](const Result<and3::Settings> &settings) {
            const bool isWanted = to == address() && isInService();
            if (isWanted && settings) {
                m_form->showSettings(*settings);
            }
            endWork();
            if (isWanted) {
                const QString fault = settings ? QString() : servicetext::fault(settings.fault());
                say(before, settings ? QString() : tr("Sensor %1 cannot be read: %2.").arg(to).arg(fault));
            }
        });
}

void And3Dialog::readLive()
{
    if (!m_form->isShown()) {
        return;
    }
    run([service = service(), to = address()](Line &line) { return service.readValues(line, to); },
        [this, to = address()](const Result<and3::ComplexRead> &values) {
            if (to == address() && m_form->isShown()) {
                m_form->showValues(values ? std::optional(*values) : std::nullopt);
            }
        });
}

void And3Dialog::write()
{
    const int to = m_form->newAddress();
    beginWork(tr("new address %1").arg(to));
    say(tr("Writing: %1…").arg(tr("new address %1").arg(to)));
    run([service = service(), from = address(),
         to](Line &line) -> Result<AddressChange> { return service.storeAddress(line, from, to); },
        [this, to](const Result<AddressChange> &change) { onWritten(to, change); });
}

void And3Dialog::onWritten(int to, const Result<AddressChange> &change)
{
    const int from = address();
    // No answer at all: the step never came to the line.
    const AddressChange done = change ? *change : AddressChange{AddressStep::Probe, change.fault()};
    const bool isGood = done.step == AddressStep::Done && done.result;
    const QString text =
        isGood ? tr("new address %1 stored, it holds after a system reset").arg(to) : changetext::failure(done, to);
    note(isGood ? JournalKind::Info : JournalKind::Error, from, text);
    say(tr("Sensor %1: %2").arg(from).arg(text));
    if (isGood) {
        m_stored = Stored{from, to, false};
    }
    const bool leaves = isLeaving();
    endWork(isGood);
    if (isGood && !leaves) {
        askForReset();
    }
}

/// The message of manual 000, section 9.11.
void And3Dialog::askForReset()
{
    auto *box = new QMessageBox(
        QMessageBox::Information, windowTitle(),
        tr("The new address %1 is stored in the sensor. Press <System reset> so that the sensor takes it.")
            .arg(m_stored->to),
        QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("resetMessage"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->addButton(tr("OK"), QMessageBox::AcceptRole)->setObjectName(QStringLiteral("resetMessageOk"));
    box->open();
}

void And3Dialog::reset()
{
    if (!isReady()) { // lost while a question was open
        return;
    }
    const int to = address();
    beginWork(tr("system reset"));
    say(tr("The sensor restarts…"));
    run([service = service(), to](Line &line) { return service.reset(line, to); },
        [this, to](const Result<void> &reset) { onReset(to, reset); });
}

void And3Dialog::onReset(int to, const Result<void> &reset)
{
    const QString text =
        reset ? tr("system reset sent") : tr("system reset not sent: %1").arg(servicetext::fault(reset.fault()));
    note(reset ? JournalKind::Info : JournalKind::Error, to, text);
    if (reset && m_stored && m_stored->from == to) {
        m_stored->isReset = true;
    }
    const bool leaves = isLeaving();
    endWork(bool(reset));
    if (!reset) {
        say(tr("Sensor %1: %2").arg(to).arg(text));
    } else if (!leaves && isInService()) {
        beginWork();
        m_restartPercent = 0;
        m_restart->start();
        m_form->showRestart(0);
    }
}

void And3Dialog::waitForRestart()
{
    m_form->showRestart(++m_restartPercent);
    const bool isOver = m_restartPercent >= 100;
    if (!isOver && isInService()) {
        return;
    }
    m_restart->stop();
    m_form->showRestart({});
    if (isInService()) {
        endWork();
        startScan(m_stored ? m_stored->to : address());
    }
}

/// After a reset: did the sensor come back where it should?
void And3Dialog::onScanned()
{
    if (!m_stored || !m_stored->isReset) {
        return;
    }
    const QList<int> found = scan()->found();
    const bool isThere = found.contains(m_stored->to);
    if (!isThere && !scan()->isComplete()) {
        return; // stopped before it came to the address: nothing is known yet
    }
    m_outcome = isThere ? tr("the sensor answers at its new address %1").arg(m_stored->to) + QStringLiteral(". ")
            + servicetext::iniReminder(port().line, SensorType::AnD3, m_stored->from, m_stored->to)
        : found.contains(m_stored->from)
        ? tr("the sensor still answers at its old address after the reset. Write the new one again.")
        : tr("the sensor answers neither at %1 nor at %2 after the reset. Scan again; check its power.")
              .arg(m_stored->to)
              .arg(m_stored->from);
    note(isThere ? JournalKind::Info : JournalKind::Error, m_stored->from, m_outcome);
    say(m_outcome);
    m_stored.reset();
}

} // namespace gorizont
