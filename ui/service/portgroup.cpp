#include "ui/service/portgroup.h"

#include "ui/service/valuelabel.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace gorizont {

PortGroup::PortGroup(const LineConfig &line, QWidget *parent)
    : QGroupBox(tr("COM port"), parent)
    , m_button(new QPushButton(this))
{
    m_button->setObjectName(QStringLiteral("portButton"));
    auto *layout = new QHBoxLayout(this);
    if (line.device.startsWith(u"tcp://")) {
        setTitle(tr("Port"));
        layout->addWidget(new QLabel(tr("Network address:"), this));
        QLabel *device = valueLabel(QStringLiteral("portDevice"), {}, this);
        device->setText(line.device);
        layout->addWidget(device);
    } else {
        addSerial(line, *layout);
    }
    layout->addStretch(1);
    layout->addWidget(m_button);
    setToolTip(tr("The configuration file decides about the port."));
    setFocusProxy(m_button);
    connect(m_button, &QPushButton::clicked, this, &PortGroup::toggleWanted);
    setInService(false);
}

void PortGroup::addSerial(const LineConfig &line, QHBoxLayout &layout)
{
    QLabel *number = valueLabel(QStringLiteral("portNumber"), QStringLiteral("256"), this);
    number->setText(QString::number(line.com));
    number->setToolTip(line.device);
    QLabel *speed = valueLabel(QStringLiteral("portSpeed"), QStringLiteral("115200"), this);
    speed->setText(QString::number(line.baudRate));
    layout.addWidget(new QLabel(tr("Number:"), this));
    layout.addWidget(number);
    layout.addSpacing(12);
    layout.addWidget(new QLabel(tr("Speed:"), this));
    layout.addWidget(speed);
}

void PortGroup::setInService(bool isInService)
{
    m_button->setText(isInService ? tr("C&lose") : tr("&Open"));
    m_button->setToolTip(
        isInService ? tr("Ends service: the sensors of the port are polled again. The window stays.")
                    : tr("Takes the port into service again and scans it."));
}

void PortGroup::setButtonEnabled(bool isEnabled)
{
    m_button->setEnabled(isEnabled);
}

} // namespace gorizont
