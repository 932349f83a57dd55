#include "ui/service/vimsdialog.h"

#include "ui/service/servicetext.h"
#include "ui/service/vimsform.h"
#include "ui/service/vimsmodulepanel.h"
#include "ui/service/vimssettingspanel.h"
#include "ui/service/vimstext.h"

#include <QComboBox>

#include <algorithm>
#include <utility>

namespace gorizont {

using namespace lvims;

VimsDialog::VimsDialog(const ServicePort &port, QWidget *parent)
    : ServiceDialog(SensorType::LVims, port, parent)
    , m_form(new VimsForm(addresses(), this))
    , m_service(std::make_shared<Service>(lvims::Address(), port.timing))
{
    setObjectName(QStringLiteral("vimsDialog"));
    scan()->hide();
    connectForm();
    setUp(m_form, m_form->tabOrder());
    m_form->setFocus();
}

void VimsDialog::connectForm()
{
    connect(m_form, &VimsForm::readWanted, this, [this] {
        confirm(unfinished(false), tr("&Discard"), [this] { read({}); });
    });
    connect(m_form, &VimsForm::writeWanted, this, &VimsDialog::askWrite);
    connect(m_form, &VimsForm::applyWanted, this, &VimsDialog::askApply);
    connect(m_form, &VimsForm::flashWanted, this, &VimsDialog::askFlash);
    connect(m_form, &VimsForm::reloadWanted, this, &VimsDialog::askReload);
    connect(m_form, &VimsForm::openWanted, this, &VimsDialog::openFile);
    connect(m_form, &VimsForm::saveWanted, this, &VimsDialog::saveFile);
    connect(m_form->module(), &VimsModulePanel::restartWanted, this, &VimsDialog::askRestart);
    connect(m_form->settings(), &VimsSettingsPanel::edited, this, [this] {
        m_form->compare(m_inUse, m_prepared);
        updateControls();
    });
}

/// The modules of the list, by their place in it: nobody knows others.
void VimsDialog::findSensors()
{
    int first = 0;
    for (const SensorConfig &sensor : port().line.sensors) {
        if (sensor.type == SensorType::LVims) {
            scan()->add(sensor.index);
            first = first == 0 ? sensor.index : first;
        }
    }
    showFoundAt(first);
    for (const SensorConfig &sensor : port().line.sensors) {
        if (const int row = addresses()->findData(sensor.index); row >= 0) {
            addresses()->setItemText(row, QStringLiteral("%1  %2").arg(sensor.number).arg(sensor.name));
        }
    }
}

ScanPanel::Probe VimsDialog::probe() const
{
    return [service = m_service](Line &line, int) -> Result<void> {
        const auto identity = service->identity(line);
        return identity ? Result<void>() : identity.fault();
    };
}

const SensorConfig &VimsDialog::module() const
{
    const auto &sensors = port().line.sensors;
    const auto isIt = [this](const SensorConfig &sensor) { return sensor.index == address(); };
    return *std::find_if(sensors.begin(), sensors.end(), isIt);
}

void VimsDialog::updateControls()
{
    m_form->setControls(
        {.isFree = isReady() && address() != 0,
         .isKnown = m_identity && !m_prepared.isEmpty(),
         .isEdited = m_form->settings()->isEdited()});
}

QString VimsDialog::unfinished(bool) const
{
    return m_form->settings()->isEdited() ? tr("What was changed here is not written to the module yet. Discard it?")
                                          : QString();
}

void VimsDialog::forget()
{
    ++m_run;
    m_identity.reset();
    m_inUse.clear();
    m_prepared.clear();
    m_form->module()->clear();
    m_form->settings()->showModule({}, {});
    m_form->showProgress(0, 0);
}

void VimsDialog::showSensor()
{
    if (address() == 0 || !isInService()) {
        forget();
        updateControls();
        return;
    }
    m_service = std::make_shared<Service>(Service::of(module(), port().timing));
    read(std::exchange(m_before, {}));
}

/// Says \a before, what was done, together with what reading brings.
void VimsDialog::read(const QString &before)
{
    if (!isInService()) { // lost while a question was open
        return;
    }
    beginWork();
    forget();
    m_before = before;
    say(before.isEmpty() ? tr("Reading the module…") : before);
    run([service = m_service](Line &line) { return service->identity(line); },
        [this, asked = m_run](const Result<Identity> &identity) {
            if (asked != m_run) {
                return;
            }
            if (!identity) {
                endReading(tr("The module cannot be read: %1. Check its power and its network cable.")
                               .arg(servicetext::fault(identity.fault())));
                return;
            }
            m_identity = *identity;
            m_form->module()->showIdentity(*identity);
            readMore(asked, moduleRegister("CUR_SETTINGS"), {});
        });
}

/// One exchange a step, so that leaving is never waited for.
void VimsDialog::readMore(int asked, const Register &set, const Image &values)
{
    run(
        [service = m_service, set, more = Image(values)](Line &line) mutable -> Result<Image> {
            const auto read = service->readMore(line, set, more);
            return read ? Result<Image>(more) : read.fault();
        },
        [this, asked, set](const Result<Image> &read) { takeSettings(asked, set, read); });
}

void VimsDialog::takeSettings(int asked, const Register &set, const Result<Image> &read)
{
    if (asked != m_run) {
        return;
    }
    if (!read) {
        endReading(tr("The settings cannot be read: %1. Read them again.").arg(servicetext::fault(read.fault())));
        return;
    }
    const bool isFirst = set == moduleRegister("CUR_SETTINGS");
    m_form->showProgress(read->size() + (isFirst ? 0 : settingsSize), 2 * settingsSize);
    if (read->size() < settingsSize) {
        readMore(asked, set, *read);
    } else if (isFirst) {
        m_inUse = *read;
        readMore(asked, moduleRegister("MUT_SETTINGS"), {});
    } else {
        m_prepared = *read;
        m_form->settings()->showModule(m_inUse, m_prepared);
        endReading({});
    }
}

void VimsDialog::endReading(const QString &text)
{
    m_form->showProgress(0, 0);
    m_form->compare(m_inUse, m_prepared);
    say(std::exchange(m_before, {}), text);
    endWork();
}

} // namespace gorizont
