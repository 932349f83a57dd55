#include "ui/service/usmdevicepanel.h"

#include "ui/models/valuetext.h"
#include "ui/service/usmtext.h"
#include "ui/service/valuelabel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QPushButton>

namespace gorizont {

UsmDevicePanel::UsmDevicePanel(QWidget *parent)
    : QWidget(parent)
{
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeIdentity());
    layout->addWidget(makeMeasuring());
    layout->addStretch(1);
    connect(m_measure, &QPushButton::clicked, this, &UsmDevicePanel::measureWanted);
}

QWidgetList UsmDevicePanel::tabOrder() const
{
    return {m_store, m_measure};
}

QGroupBox *UsmDevicePanel::makeIdentity()
{
    auto *group = new QGroupBox(tr("About the device"), this);
    m_serial = valueLabel(QStringLiteral("deviceSerial"), QStringLiteral("00000000"), group);
    m_type = valueLabel(QStringLiteral("deviceType"), tr("%1, not an УСМ-ИСН").arg(999), group);
    m_program = valueLabel(QStringLiteral("deviceProgram"), QStringLiteral("00.00.0000"), group);
    m_calibratedOn = valueLabel(QStringLiteral("calibratedOn"), QStringLiteral("00.00.0000"), group);
    m_calibrations = valueLabel(QStringLiteral("calibrations"), QStringLiteral("4294967295"), group);
    m_channels = valueLabel(QStringLiteral("deviceChannels"), {}, group);
    m_channels->setMinimumHeight(2 * fontMetrics().lineSpacing());
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(tr("Serial number:"), group), 0, 0);
    grid->addWidget(m_serial, 0, 1);
    grid->addWidget(new QLabel(tr("Type:"), group), 0, 2);
    grid->addWidget(m_type, 0, 3);
    grid->addWidget(new QLabel(tr("Calibrated on:"), group), 1, 0);
    grid->addWidget(m_calibratedOn, 1, 1);
    grid->addWidget(new QLabel(tr("Calibrations so far:"), group), 1, 2);
    grid->addWidget(m_calibrations, 1, 3);
    grid->addWidget(new QLabel(tr("Program of:"), group), 2, 0);
    grid->addWidget(m_program, 2, 1);
    grid->addWidget(new QLabel(tr("Channels:"), group), 3, 0, Qt::AlignTop);
    grid->addWidget(m_channels, 3, 1, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return group;
}

QGroupBox *UsmDevicePanel::makeMeasuring()
{
    auto *group = new QGroupBox(tr("Measuring now"), this);
    m_x = valueLabel(QStringLiteral("valueX"), {}, group);
    m_y = valueLabel(QStringLiteral("valueY"), {}, group);
    for (QLabel *label : {m_x, m_y}) {
        label->setWordWrap(true);
    }
    m_store = new QCheckBox(tr("Keep it in the memory of the device"), group);
    m_store->setObjectName(QStringLiteral("storeValue"));
    m_store->setToolTip(tr("Takes two of the %1 records; the oldest ones are overwritten.").arg(usmisn::memorySize));
    m_measure = new QPushButton(tr("&Measure"), group);
    m_measure->setObjectName(QStringLiteral("measure"));
    m_measure->setToolTip(tr("Up to 1.5 s an axis"));
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(QStringLiteral("X:"), group), 0, 0);
    grid->addWidget(m_x, 0, 1);
    grid->addWidget(new QLabel(QStringLiteral("Y:"), group), 1, 0);
    grid->addWidget(m_y, 1, 1);
    grid->addWidget(m_store, 2, 0, 1, 2);
    grid->addWidget(m_measure, 2, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

void UsmDevicePanel::showIdentity(const usmisn::Identity &identity)
{
    m_serial->setText(usmtext::serial(identity.serial));
    if (!identity.isInclinometer()) {
        m_type->setText(tr("%1, not an УСМ-ИСН").arg(identity.type));
        return;
    }
    m_type->setText(QStringLiteral("%1").arg(identity.type, 3, 10, QLatin1Char('0')));
    m_program->setText(usmtext::date(identity.program));
    m_calibratedOn->setText(usmtext::date(identity.calibratedOn));
    m_calibrations->setText(QString::number(identity.calibrations));
    QStringList channels;
    for (const usmisn::Channel &channel : identity.channels) {
        channels += QStringLiteral("%1: %2, %3")
                        .arg(channel.id.value, 10, 10, QLatin1Char('0'))
                        .arg(channel.description, channel.units);
    }
    m_channels->setText(channels.join(u'\n'));
}

void UsmDevicePanel::clear()
{
    for (QLabel *label : {m_serial, m_type, m_program, m_calibratedOn, m_calibrations, m_channels, m_x, m_y}) {
        label->clear();
    }
}

void UsmDevicePanel::showValue(int channel, const std::optional<Result<usmisn::Value>> &value)
{
    QLabel *label = channel == usmisn::channelX ? m_x : m_y;
    label->setText(value ? usmtext::value(*value) : valuetext::absent());
}

void UsmDevicePanel::setMayMeasure(bool mayMeasure)
{
    m_measure->setEnabled(mayMeasure);
    m_store->setEnabled(mayMeasure);
}

bool UsmDevicePanel::isStored() const
{
    return m_store->isChecked();
}

} // namespace gorizont
