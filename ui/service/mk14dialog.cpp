#include "ui/service/mk14dialog.h"

#include "ui/models/weathertext.h"
#include "ui/service/mk14form.h"
#include "ui/service/mk14outputspanel.h"
#include "ui/service/mk14transferpanel.h"
#include "ui/service/mk14valuespanel.h"
#include "ui/service/servicetext.h"

#include <QComboBox>

namespace gorizont {

namespace {

QMap<int, mk14::Options> stationsOf(const LineConfig &line)
{
    QMap<int, mk14::Options> stations;
    for (const SensorConfig &sensor : line.sensors) {
        if (sensor.type == SensorType::Mk14) {
            stations.insert(sensor.address, mk14::Options::from(sensor));
        }
    }
    return stations;
}

} // namespace

Mk14Dialog::Mk14Dialog(const ServicePort &port, QWidget *parent)
    : ServiceDialog(SensorType::Mk14, port, parent)
    , m_form(new Mk14Form(addresses(), this))
    , m_options(stationsOf(port.line))
{
    setObjectName(QStringLiteral("mk14Dialog"));
    connect(m_form->values(), &Mk14ValuesPanel::readWanted, this, &Mk14Dialog::readNow);
    connect(m_form->outputs(), &Mk14OutputsPanel::edited, this, &Mk14Dialog::updateControls);
    connect(m_form->outputs(), &Mk14OutputsPanel::setWanted, this, &Mk14Dialog::askOutputs);
    connect(m_form->transfer(), &Mk14TransferPanel::edited, this, &Mk14Dialog::updateControls);
    connect(m_form->transfer(), &Mk14TransferPanel::timeWanted, this, &Mk14Dialog::askTime);
    connect(m_form->transfer(), &Mk14TransferPanel::fileWanted, this, &Mk14Dialog::chooseFile);
    connect(m_form->transfer(), &Mk14TransferPanel::sendWanted, this, &Mk14Dialog::askFile);
    setUp(m_form, m_form->tabOrder());
}

ScanPanel::Probe Mk14Dialog::probe() const
{
    return [stations = m_options, timing = port().timing](Line &line, int address) -> Result<void> {
        const auto station = stations.constFind(address);
        if (station == stations.constEnd()) {
            return Fault::Timeout; // nobody is asked whose outputs nobody knows
        }
        const auto answer = mk14::Service(*station, timing).read(line, address, 1);
        return answer ? Result<void>() : answer.fault();
    };
}

mk14::Service Mk14Dialog::service() const
{
    return {m_options.value(address()), port().timing};
}

precipitation::StationClock Mk14Dialog::clock() const
{
    return m_options.value(address()).isClockUtc ? precipitation::StationClock::Utc
                                                 : precipitation::StationClock::Local;
}

void Mk14Dialog::updateControls()
{
    const bool isShown = isReady() && m_isShown;
    m_form->values()->setMayRead(isReady() && address() != 0);
    m_form->outputs()->setControls(isShown);
    m_form->transfer()->setControls(isShown);
}

QString Mk14Dialog::unfinished(bool) const
{
    return m_form->outputs()->isEdited()
        ? tr("The new control word of station %1 was not sent. Discard it?").arg(address())
        : QString();
}

void Mk14Dialog::forget()
{
    m_isShown = false;
    m_form->values()->clear();
    m_form->outputs()->showWord({});
    updateControls();
}

void Mk14Dialog::showSensor()
{
    forget();
    m_form->transfer()->showClock(QDateTime::currentDateTime(), clock());
    if (address() != 0 && isInService()) {
        readNow();
    }
}

void Mk14Dialog::readLive()
{
    m_form->transfer()->showClock(QDateTime::currentDateTime(), clock());
}

void Mk14Dialog::readNow()
{
    if (!isReady()) {
        return;
    }
    beginWork();
    say(tr("Reading station %1…").arg(address()));
    run(
        [service = service(), to = address(), command = m_form->values()->command()](Line &line) -> Result<Shown> {
            const auto weather = service.read(line, to, command);
            return weather ? Result<Shown>({*weather, service.outputs(line, to)}) : weather.fault();
        },
        [this, to = address()](const Result<Shown> &read) { showRead(to, read); });
}

/// Of what is typed nothing is lost when values are read again.
void Mk14Dialog::showRead(int to, const Result<Shown> &read)
{
    const bool isWanted = to == address() && isInService();
    if (isWanted && read) {
        m_isShown = true;
        m_form->values()->showWeather(
            read->weather, clock(), precipitation::stationTime(QDateTime::currentDateTime(), clock()));
        if (!m_form->outputs()->isEdited()) {
            m_form->outputs()->showWord(read->outputs);
        }
    }
    endWork();
    if (!isWanted) {
        return;
    }
    if (!read) {
        m_form->values()->clear();
        say(tr("Station %1 cannot be read: %2.").arg(to).arg(servicetext::fault(read.fault())));
    } else if (read->weather.parameters.isEmpty()) {
        say(tr("Station %1 answers, but it has no data yet.").arg(to));
    } else {
        say(tr("Station %1 was read.").arg(to));
    }
}

} // namespace gorizont
