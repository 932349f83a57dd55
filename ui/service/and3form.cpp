#include "ui/service/and3form.h"

#include "ui/models/valuetext.h"
#include "ui/service/servicetext.h"
#include "ui/service/valuelabel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QProgressBar>
#include <QPushButton>

namespace gorizont {

And3Form::And3Form(QComboBox *addresses, QWidget *parent)
    : QWidget(parent)
    , m_addresses(addresses)
{
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeExchange(addresses), 0, 0);
    layout->addWidget(makeData(), 0, 1);
    layout->addWidget(makeSystem(), 1, 0, 1, 2);
    layout->setColumnStretch(0, 1);
    layout->setColumnStretch(1, 1);
    connect(m_newAddress, &QComboBox::activated, this, &And3Form::chosen);
    connect(m_write, &QPushButton::clicked, this, &And3Form::writeWanted);
    connect(m_reset, &QPushButton::clicked, this, &And3Form::resetWanted);
    showRestart({});
    clear();
}

QWidgetList And3Form::tabOrder() const
{
    return {m_addresses, m_change, m_newAddress, m_write, m_reset};
}

QGroupBox *And3Form::makeExchange(QComboBox *addresses)
{
    auto *group = new QGroupBox(tr("Exchange"), this);
    addresses->setParent(group);
    m_change = new QPushButton(tr("Change"), group);
    m_change->setObjectName(QStringLiteral("changeAddress"));
    m_change->setEnabled(false);
    m_change->setToolTip(
        tr("The address of %1 is changed in the group <System>.").arg(servicetext::deviceName(SensorType::AnD3)));
    auto *label = new QLabel(tr("&Address on the line:"), group);
    label->setBuddy(addresses);
    auto *grid = new QGridLayout(group);
    grid->addWidget(label, 0, 0);
    grid->addWidget(addresses, 0, 1);
    grid->addWidget(m_change, 0, 2);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 1);
    return group;
}

QGroupBox *And3Form::makeData()
{
    auto *group = new QGroupBox(tr("Data"), this);
    m_temperature = valueLabel(QStringLiteral("liveTemperature"), QStringLiteral("-131.07"), group);
    m_tilt = valueLabel(QStringLiteral("liveTilt"), QStringLiteral("-16383.9 -16383.9"), group);
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(tr("Temperature, °C:"), group), 0, 0);
    grid->addWidget(m_temperature, 0, 1);
    grid->addWidget(new QLabel(tr("Tilt X, Y, ″:"), group), 1, 0);
    grid->addWidget(m_tilt, 1, 1);
    grid->setColumnStretch(1, 1);
    return group;
}

QGroupBox *And3Form::makeSystem()
{
    auto *group = new QGroupBox(tr("System"), this);
    m_address = valueLabel(QStringLiteral("currentAddress"), QStringLiteral("255"), group);
    m_firmware = valueLabel(QStringLiteral("firmware"), QStringLiteral("255.255.255"), group);
    m_newAddress = new QComboBox(group);
    m_newAddress->setObjectName(QStringLiteral("newAddressCombo"));
    m_write = new QPushButton(tr("&Write"), group);
    m_write->setObjectName(QStringLiteral("writeAddress"));
    m_write->setDefault(true);
    m_reset = new QPushButton(tr("System &reset"), group);
    m_reset->setObjectName(QStringLiteral("systemReset"));
    m_reset->setToolTip(
        tr("Restarts the controller of the sensor, about five seconds. Its memory of samples is lost."));
    m_restart = new QProgressBar(group);
    m_restart->setObjectName(QStringLiteral("restartProgress"));
    m_restart->setTextVisible(false);
    QSizePolicy keepsPlace = m_restart->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_restart->setSizePolicy(keepsPlace);
    auto *label = new QLabel(tr("Set a &new address:"), group);
    label->setBuddy(m_newAddress);
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(tr("Current address:"), group), 0, 0);
    grid->addWidget(m_address, 0, 1);
    grid->addWidget(new QLabel(tr("Firmware:"), group), 0, 2);
    grid->addWidget(m_firmware, 0, 3);
    grid->addWidget(label, 1, 0);
    grid->addWidget(m_newAddress, 1, 1);
    grid->addWidget(m_write, 1, 2);
    grid->addWidget(m_restart, 2, 0, 1, 2);
    grid->addWidget(m_reset, 2, 2, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return group;
}

void And3Form::showSettings(const and3::Settings &settings)
{
    m_isShown = true;
    m_address->setText(QString::number(settings.address));
    m_firmware->setText(
        settings.firmware ? QStringLiteral("%1.%2.%3")
                                .arg(settings.firmware->version)
                                .arg(settings.firmware->subVersion)
                                .arg(settings.firmware->build)
                          : valuetext::absent());
    showValues(settings.values);
}

void And3Form::showValues(const std::optional<and3::ComplexRead> &values)
{
    const bool hasTemperature = values && values->rawStatus & and3::statusbit::TemperatureReady;
    const bool hasTilt = values && values->rawStatus & and3::statusbit::TiltReady;
    m_temperature->setText(hasTemperature ? valuetext::fixed(values->temperature, 2) : valuetext::absent());
    m_tilt->setText(
        hasTilt ? valuetext::signedFixed(values->tilt.x, 1) + u' ' + valuetext::signedFixed(values->tilt.y, 1)
                : valuetext::absent());
}

void And3Form::clear()
{
    m_isShown = false;
    for (QLabel *label : {m_temperature, m_tilt, m_address, m_firmware}) {
        label->clear();
    }
}

void And3Form::offer(const LineConfig &line, const QList<int> &free)
{
    m_newAddress->clear();
    for (const int address : free) {
        m_newAddress->addItem(servicetext::addressTitle(line, address), address);
    }
    m_newAddress->setCurrentIndex(-1);
}

int And3Form::newAddress() const
{
    return m_newAddress->currentData().toInt();
}

void And3Form::setControls(bool mayChoose, bool mayWrite, bool mayReset)
{
    m_newAddress->setEnabled(mayChoose);
    m_newAddress->setToolTip(
        mayChoose ? tr("Addresses where nobody answered")
                  : tr("The address can be changed only after a complete scan that was not stopped."));
    m_write->setEnabled(mayWrite);
    m_reset->setEnabled(mayReset);
}

void And3Form::showRestart(std::optional<int> percent)
{
    m_restart->setVisible(percent.has_value());
    m_restart->setValue(percent.value_or(0));
}

} // namespace gorizont
