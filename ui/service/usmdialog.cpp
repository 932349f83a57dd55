#include "ui/service/usmdialog.h"

#include "ui/service/recordstream.h"
#include "ui/service/servicetext.h"
#include "ui/service/usmdevicepanel.h"
#include "ui/service/usmform.h"
#include "ui/service/usmrecorderpanel.h"
#include "ui/service/usmrecordspanel.h"
#include "ui/service/usmsettingspanel.h"

#include <QComboBox>
#include <QTimer>

namespace gorizont {

using namespace usmisn;

namespace {

constexpr std::chrono::milliseconds drainPeriod(200);

/// The first one of the list of the port, where a recorder may sleep that no scan finds.
int firstAddress(const LineConfig &line)
{
    for (const SensorConfig &sensor : line.sensors) {
        if (sensor.type == SensorType::UsmIsn) {
            return sensor.address;
        }
    }
    return 1;
}

} // namespace

UsmDialog::UsmDialog(const ServicePort &port, QWidget *parent, const Pauses &pauses)
    : ServiceDialog(SensorType::UsmIsn, port, parent)
    , m_form(new UsmForm(addresses(), this))
    , m_service(port.timing)
    , m_pauses(pauses)
    , m_silence(new QTimer(this))
    , m_drain(new QTimer(this))
{
    setObjectName(QStringLiteral("usmDialog"));
    m_silence->setInterval(pauses.silence / 100);
    m_drain->setInterval(drainPeriod);
    connect(m_silence, &QTimer::timeout, this, &UsmDialog::countSilence);
    connect(m_drain, &QTimer::timeout, this, &UsmDialog::takeRecords);
    m_form->recorder()->setWakeAddress(firstAddress(port.line));
    connectForm();
    setUp(m_form, m_form->tabOrder());
}

UsmDialog::~UsmDialog()
{
    UsmDialog::breakOff();
}

void UsmDialog::connectForm()
{
    connect(m_form, &UsmForm::findWanted, this, &UsmDialog::find);
    connect(m_form->device(), &UsmDevicePanel::measureWanted, this, &UsmDialog::measure);
    connect(m_form->settings(), &UsmSettingsPanel::chosen, this, &UsmDialog::updateControls);
    connect(m_form->settings(), &UsmSettingsPanel::addressWanted, this, &UsmDialog::askAddress);
    connect(m_form->settings(), &UsmSettingsPanel::portWanted, this, [this] { askPort(false); });
    connect(m_form->settings(), &UsmSettingsPanel::factoryPortWanted, this, [this] { askPort(true); });
    connect(m_form->settings(), &UsmSettingsPanel::silenceWanted, this, &UsmDialog::keepSilent);
    connect(m_form->recorder(), &UsmRecorderPanel::chosen, this, &UsmDialog::updateControls);
    connect(m_form->recorder(), &UsmRecorderPanel::startWanted, this, &UsmDialog::askStart);
    connect(m_form->recorder(), &UsmRecorderPanel::wakeWanted, this, &UsmDialog::wake);
    connect(m_form->recorder(), &UsmRecorderPanel::wakingStopped, this, [this] { m_isWakingStopped = true; });
    connect(m_form->records(), &UsmRecordsPanel::downloadWanted, this, &UsmDialog::download);
    connect(m_form->records(), &UsmRecordsPanel::stopWanted, this, &UsmDialog::breakOff);
    connect(m_form->records(), &UsmRecordsPanel::saveWanted, this, &UsmDialog::saveRecords);
}

/// A scan looks for every device of the series: reading tells which it is.
ScanPanel::Probe UsmDialog::probe() const
{
    return [service = m_service](Line &line, int address) -> Result<void> {
        const auto type = service.probe(line, address);
        return type ? Result<void>() : type.fault();
    };
}

void UsmDialog::updateControls()
{
    const bool isFree = isReady();
    const bool isShown = isFree && m_identity && m_identity->isInclinometer();
    addresses()->setEnabled(addresses()->isEnabled() && m_task == Task::None);
    m_form->setMayFind(isFree);
    m_form->device()->setMayMeasure(isShown);
    m_form->settings()->setControls(isFree, isShown, scan()->isComplete());
    m_form->recorder()->setControls(isFree, isShown);
    m_form->records()->setControls(isShown, isGoingOn(Task::Download), m_book.size() > 0);
}

QString UsmDialog::unfinished(bool) const
{
    switch (m_task) {
    case Task::Download:
        return tr("Records are still being downloaded. Break it off? What the device has sent meanwhile only <Download "
                  "all> brings again.");
    case Task::Wake: return tr("The recorder is still being woken. Break it off?");
    default: break;
    }
    return {};
}

/// What runs in the thread of the line ends soon; what it has brought is kept.
void UsmDialog::breakOff()
{
    if (m_stream) {
        m_stream->stop();
        takeRecords();
    }
    m_isWakingStopped = true;
}

/// Of a session that is over nobody answers any more.
void UsmDialog::dropTask()
{
    m_task = Task::None;
    m_drain->stop();
    m_fetch.reset();
    m_stream.reset();
    m_form->recorder()->showWaking({});
}

bool UsmDialog::begin(Task task)
{
    if (!isReady()) { // lost while a question was open
        return false;
    }
    m_task = task;
    beginWork();
    return true;
}

void UsmDialog::end()
{
    m_task = Task::None;
    endWork();
}

void UsmDialog::showSensor()
{
    read(std::exchange(m_before, {}));
}

/// Says \a before, what was done, together with what reading brings.
void UsmDialog::read(const QString &before)
{
    const bool isToRead = address() != 0 && isInService();
    if (isToRead) {
        beginWork(); // first, so that the focus is remembered
    }
    dropTask();
    m_identity.reset();
    m_form->device()->clear();
    m_form->settings()->offer(port().line, scan()->free());
    if (!isToRead) {
        updateControls();
        return;
    }
    say(before.isEmpty() ? tr("Reading sensor %1…").arg(address()) : before);
    run([service = m_service, to = address()](Line &line) { return service.read(line, to); },
        [this, before, to = address()](const Result<Identity> &identity) { showRead(to, identity, before); });
}

void UsmDialog::showRead(int to, const Result<Identity> &identity, const QString &before)
{
    const bool isWanted = to == address() && isInService();
    if (isWanted && identity) {
        m_identity = *identity;
        m_form->device()->showIdentity(*identity);
        m_form->recorder()->setWakeAddress(to);
        findArchive();
    }
    endWork();
    if (!isWanted) {
        return;
    }
    if (!identity) {
        say(before, tr("Sensor %1 cannot be read: %2.").arg(to).arg(servicetext::fault(identity.fault())));
    } else if (!identity->isInclinometer()) {
        say(before,
            tr("This is another device of the УСМ series (type %1); nothing of it can be set here.")
                .arg(identity->type));
    } else {
        say(before);
    }
}

} // namespace gorizont
