#include "ui/service/ind3dialog.h"

#include "ui/service/changetext.h"
#include "ui/service/ind3form.h"
#include "ui/service/newaddressdialog.h"
#include "ui/service/servicetext.h"

#include <QComboBox>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

/// Of the first ИН-Д3 in the list of the port; its old protocol knows no settings.
ind3::Dialect usualDialect(const LineConfig &line)
{
    for (const SensorConfig &sensor : line.sensors) {
        const auto dialect = ind3::dialectNamed(sensor.options.value(ind3::dialectOption));
        if (sensor.type == SensorType::InD && dialect && *dialect != ind3::Dialect::V210) {
            return *dialect;
        }
    }
    return ind3::Dialect::V211;
}

} // namespace

Ind3Dialog::Ind3Dialog(const ServicePort &port, QWidget *parent)
    : ServiceDialog(SensorType::InD, port, parent)
    , m_change(new QPushButton(tr("C&hange"), this))
    , m_protocols(new QComboBox(this))
    , m_form(new Ind3Form(addresses(), m_change, m_protocols, this))
    , m_apply(new QPushButton(tr("Apply the ne&w settings"), this))
{
    setObjectName(QStringLiteral("ind3Dialog"));
    m_change->setObjectName(QStringLiteral("changeAddress"));
    m_protocols->setObjectName(QStringLiteral("protocolCombo"));
    m_protocols->addItem(QStringLiteral("2.11"), static_cast<int>(ind3::Dialect::V211));
    m_protocols->addItem(QStringLiteral("Modbus RTU"), static_cast<int>(ind3::Dialect::Modbus));
    m_protocols->setToolTip(tr("Only sensors that speak this protocol are found. Another choice begins a new scan."));
    m_dialect = m_protocols->findData(static_cast<int>(usualDialect(port.line)));
    m_protocols->setCurrentIndex(m_dialect);
    m_apply->setObjectName(QStringLiteral("applySettings"));
    m_apply->setDefault(true);
    connect(m_form, &Ind3Form::edited, this, &Ind3Dialog::updateControls);
    connect(m_apply, &QPushButton::clicked, this, &Ind3Dialog::apply);
    connect(m_change, &QPushButton::clicked, this, [this] {
        confirm(unfinished(false), tr("&Discard"), [this] { askNewAddress(); });
    });
    connect(m_protocols, &QComboBox::activated, this, [this](int index) {
        if (index != m_dialect) {
            confirm(
                unfinished(false), tr("&Discard"),
                [this, index] {
                    m_dialect = index;
                    startScan();
                },
                [this] { m_protocols->setCurrentIndex(m_dialect); });
        }
    });
    setUp(m_form, m_form->tabOrder(), m_apply);
}

ind3::Service Ind3Dialog::service() const
{
    return {port().timing, static_cast<ind3::Dialect>(m_protocols->itemData(m_dialect).toInt())};
}

ScanPanel::Probe Ind3Dialog::probe() const
{
    return [service = service()](Line &line, int address) { return service.probe(line, address); };
}

void Ind3Dialog::updateControls()
{
    const bool isShown = isReady() && m_form->settings();
    m_form->setEditable(isShown);
    m_protocols->setEnabled(isReady());
    m_apply->setEnabled(isShown && !m_form->changes().isEmpty() && m_form->problem().isEmpty());
    m_change->setEnabled(isShown && scan()->isComplete());
    m_change->setToolTip(
        scan()->isComplete() ? tr("Gives the sensor another address")
                             : tr("The address can be changed only after a complete scan that was not stopped."));
}

QString Ind3Dialog::unfinished(bool) const
{
    return m_form->isEdited() ? tr("The new settings of sensor %1 were not applied. Discard them?").arg(address())
                              : QString();
}

void Ind3Dialog::showSensor()
{
    read({});
}

/// Says \a before, what was done, together with what reading brings.
void Ind3Dialog::read(const QString &before)
{
    if (address() == 0 || !isInService()) {
        m_form->clear();
        updateControls();
        return;
    }
    beginWork(); // first, so that the focus is remembered
    m_form->clear();
    say(before.isEmpty() ? tr("Reading sensor %1…").arg(address()) : before);
    run([service = service(), to = address()](Line &line) { return service.read(line, to); },
        [this, before, to = address()](const Result<ind3::Settings> &settings) {
            const bool isWanted = to == address() && isInService();
            if (isWanted && settings) {
                m_form->showSettings(*settings);
            }
            endWork();
            if (isWanted) {
                say(before, readText(to, settings));
            }
        });
}

QString Ind3Dialog::readText(int to, const Result<ind3::Settings> &settings) const
{
    if (!settings) {
        return tr("Sensor %1 cannot be read: %2.").arg(to).arg(servicetext::fault(settings.fault()));
    }
    return settings->selfTest ? tr("The sensor reports that a check sum of its memory is wrong: it needs repair.")
                              : QString();
}

void Ind3Dialog::readLive()
{
    if (!m_form->settings()) {
        return;
    }
    run([service = service(), to = address()](Line &line) { return service.readTilt(line, to); },
        [this, to = address()](const Result<Tilt> &tilt) {
            if (to == address() && m_form->settings()) {
                m_form->showTilt(tilt ? std::optional(*tilt) : std::nullopt);
            }
        });
}

void Ind3Dialog::apply()
{
    m_toWrite = changetext::oneByOne(m_form->changes());
    m_report.clear();
    m_isGood = true;
    writeNext();
}

void Ind3Dialog::writeNext()
{
    if (m_toWrite.isEmpty()) {
        finishWriting();
        return;
    }
    const ind3::Changes change = m_toWrite.takeFirst();
    beginWork(changetext::setting(change));
    say(tr("Writing: %1…").arg(changetext::setting(change)));
    run([service = service(), to = address(),
         change](Line &line) -> Result<QList<ind3::Outcome>> { return service.write(line, to, change); },
        [this, change](const Result<QList<ind3::Outcome>> &outcome) { take(change, outcome); });
}

void Ind3Dialog::take(const ind3::Changes &change, const Result<QList<ind3::Outcome>> &outcome)
{
    // No outcome: the step never came to the line.
    const Result<void> written = !outcome ? Result<void>(outcome.fault())
        : outcome->isEmpty()              ? Result<void>(Fault::Cancelled)
                                          : outcome->first().written;
    const QString sentence = changetext::setting(change) + QStringLiteral(", ") + changetext::outcome(written);
    note(written ? JournalKind::Info : JournalKind::Error, address(), sentence);
    m_report += sentence;
    m_isGood = m_isGood && written;
    const bool isLost = !written && isLineFault(written.fault());
    if ((isLost || isLeaving()) && !m_toWrite.isEmpty()) {
        m_isGood = false;
        for (const ind3::Changes &left : std::exchange(m_toWrite, {})) {
            const QString untried = tr("%1, not written").arg(changetext::setting(left));
            note(JournalKind::Error, address(), untried);
            m_report += untried;
        }
    }
    writeNext();
}

/// Reads everything back, unless somebody wants to leave or the port is gone.
void Ind3Dialog::finishWriting()
{
    const QString report = tr("Sensor %1: %2.").arg(address()).arg(m_report.join(QStringLiteral("; ")));
    say(report);
    if (isLeaving() || !isInService()) {
        m_form->clear();
        endWork(m_isGood);
        return;
    }
    endWork();
    read(report);
}

void Ind3Dialog::askNewAddress()
{
    if (!isReady() || !scan()->isComplete() || address() == 0 || m_newAddress) {
        return;
    }
    m_newAddress = new NewAddressDialog(port().line, address(), scan()->free(), this);
    connect(m_newAddress, &QDialog::accepted, this, [this] { changeAddress(m_newAddress->address()); });
    m_newAddress->open();
}

void Ind3Dialog::changeAddress(int newAddress)
{
    if (!isReady() || newAddress == 0) { // lost while the window was open
        return;
    }
    const int from = address();
    beginWork(tr("new address %1").arg(newAddress));
    m_form->clear();
    say(tr("Writing: %1…").arg(tr("new address %1").arg(newAddress)));
    run([service = service(), from, newAddress](Line &line) { return service.changeAddress(line, from, newAddress); },
        [this, from, newAddress](const Result<void> &changed) { onAddressChanged(from, newAddress, changed); });
}

void Ind3Dialog::onAddressChanged(int from, int to, const Result<void> &changed)
{
    const QString what = tr("new address %1").arg(to);
    QString text;
    if (changed) {
        text = tr("%1, written").arg(what) + QStringLiteral(". ")
            + servicetext::iniReminder(port().line, SensorType::InD, from, to);
        moveTo(to);
    } else {
        scan()->distrust();
        switch (changed.fault()) {
        case Fault::Refused:
            text = tr("%1, not written: it is taken, or the sensor will not. Scan again.").arg(what);
            break;
        case Fault::BadReply: text = tr("%1, not written: the sensor still answers at %2").arg(what).arg(from); break;
        default:
            text = tr("%1, %2: whether it was written is not known. Scan the line to find the sensor.")
                       .arg(what, servicetext::fault(changed.fault()));
        }
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

} // namespace gorizont
