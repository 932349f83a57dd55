#include "ui/service/usmsettingspanel.h"

#include "ui/service/servicetext.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace gorizont {

namespace {

QComboBox *makeList(const QString &objectName, QWidget *parent)
{
    auto *list = new QComboBox(parent);
    list->setObjectName(objectName);
    return list;
}

QPushButton *makeButton(const QString &text, const QString &objectName, QWidget *parent)
{
    auto *button = new QPushButton(text, parent);
    button->setObjectName(objectName);
    button->setAutoDefault(false);
    return button;
}

} // namespace

UsmSettingsPanel::UsmSettingsPanel(QWidget *parent)
    : QWidget(parent)
    , m_forAll(new QCheckBox(tr("For all devices on the line (none of them answers)"), this))
{
    m_forAll->setObjectName(QStringLiteral("settingsForAll"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeAddress());
    layout->addWidget(makePort());
    layout->addWidget(m_forAll);
    layout->addWidget(makeSilence());
    layout->addStretch(1);
    connect(m_newAddress, &QComboBox::activated, this, &UsmSettingsPanel::chosen);
    connect(m_forAll, &QCheckBox::toggled, this, &UsmSettingsPanel::chosen);
    connect(m_writeAddress, &QPushButton::clicked, this, &UsmSettingsPanel::addressWanted);
    connect(m_writePort, &QPushButton::clicked, this, &UsmSettingsPanel::portWanted);
    connect(m_factoryPort, &QPushButton::clicked, this, &UsmSettingsPanel::factoryPortWanted);
    connect(m_keepSilent, &QPushButton::clicked, this, &UsmSettingsPanel::silenceWanted);
    showSilence({});
}

QWidgetList UsmSettingsPanel::tabOrder() const
{
    return {m_newAddress,  m_writeAddress, m_baud,   m_parity,    m_stopBits,
            m_factoryPort, m_writePort,    m_forAll, m_keepSilent};
}

QGroupBox *UsmSettingsPanel::makeAddress()
{
    auto *group = new QGroupBox(tr("Address"), this);
    m_newAddress = makeList(QStringLiteral("newAddressCombo"), group);
    m_writeAddress = makeButton(tr("Write the &address"), QStringLiteral("writeAddress"), group);
    auto *label = new QLabel(tr("&New address:"), group);
    label->setBuddy(m_newAddress);
    auto *grid = new QGridLayout(group);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_newAddress, 0, 1);
    grid->addWidget(m_writeAddress, 0, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

/// Stop bits 0.5 are not offered: this program could not follow.
QGroupBox *UsmSettingsPanel::makePort()
{
    auto *group = new QGroupBox(tr("Port settings"), this);
    m_baud = makeList(QStringLiteral("baudCombo"), group);
    for (const int baud : {1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200}) {
        m_baud->addItem(QString::number(baud), baud);
    }
    m_parity = makeList(QStringLiteral("parityCombo"), group);
    m_parity->addItem(tr("none"), static_cast<int>(Parity::None));
    m_parity->addItem(tr("even"), static_cast<int>(Parity::Even));
    m_parity->addItem(tr("odd"), static_cast<int>(Parity::Odd));
    m_stopBits = makeList(QStringLiteral("stopBitsCombo"), group);
    m_stopBits->addItem(QStringLiteral("1"), static_cast<int>(StopBits::One));
    m_stopBits->addItem(QStringLiteral("1.5"), static_cast<int>(StopBits::OneAndHalf));
    m_stopBits->addItem(QStringLiteral("2"), static_cast<int>(StopBits::Two));
    m_baud->setCurrentIndex(m_baud->findData(usmisn::factoryPort.baudRate));
    m_factoryPort = makeButton(tr("Factory settings 9600-N-1"), QStringLiteral("factoryPort"), group);
    m_writePort = makeButton(tr("Write the &port settings"), QStringLiteral("writePort"), group);
    m_writePort->setToolTip(tr("Afterwards the device is asked at the new settings."));
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(tr("Speed:"), group), 0, 0);
    grid->addWidget(m_baud, 0, 1);
    grid->addWidget(new QLabel(tr("Parity:"), group), 0, 2);
    grid->addWidget(m_parity, 0, 3);
    grid->addWidget(new QLabel(tr("Stop bits:"), group), 0, 4);
    grid->addWidget(m_stopBits, 0, 5);
    grid->addWidget(m_factoryPort, 1, 0, 1, 3, Qt::AlignLeading);
    grid->addWidget(m_writePort, 1, 3, 1, 3, Qt::AlignTrailing);
    for (const int column : {1, 3, 5}) {
        grid->setColumnStretch(column, 1);
    }
    return group;
}

QGroupBox *UsmSettingsPanel::makeSilence()
{
    auto *group = new QGroupBox(tr("A device hangs"), this);
    m_silence = new QProgressBar(group);
    m_silence->setObjectName(QStringLiteral("silenceProgress"));
    m_silence->setTextVisible(false);
    m_keepSilent = makeButton(tr("Keep silent for 30 s"), QStringLiteral("keepSilent"), group);
    m_keepSilent->setToolTip(tr("Every УСМ restarts that hears no message for 26 s, those that do not hang too."));
    auto *grid = new QGridLayout(group);
    grid->addWidget(m_silence, 0, 0);
    grid->addWidget(m_keepSilent, 0, 1);
    grid->setColumnStretch(0, 1);
    return group;
}

void UsmSettingsPanel::offer(const LineConfig &line, const QList<int> &free)
{
    m_newAddress->clear();
    for (const int address : free) {
        m_newAddress->addItem(servicetext::addressTitle(line, address), address);
    }
    m_newAddress->setCurrentIndex(-1);
}

void UsmSettingsPanel::setControls(bool isReady, bool isShown, bool isComplete)
{
    const bool mayWrite = isShown || (isReady && isForAll());
    m_newAddress->setEnabled(mayWrite && isComplete);
    m_newAddress->setToolTip(
        isComplete ? tr("Addresses where nobody answered")
                   : tr("The address can be changed only after a complete scan that was not stopped."));
    m_writeAddress->setEnabled(mayWrite && isComplete && newAddress() != 0);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_baud, m_parity, m_stopBits, m_writePort, m_factoryPort}) {
        widget->setEnabled(mayWrite);
    }
    m_forAll->setEnabled(isReady);
    m_keepSilent->setEnabled(isReady);
}

void UsmSettingsPanel::showSilence(std::optional<int> percent)
{
    m_silence->setValue(percent.value_or(0));
}

int UsmSettingsPanel::newAddress() const
{
    return m_newAddress->currentData().toInt();
}

PortSettings UsmSettingsPanel::portSettings() const
{
    return {
        m_baud->currentData().toInt(), static_cast<Parity>(m_parity->currentData().toInt()),
        static_cast<StopBits>(m_stopBits->currentData().toInt())};
}

bool UsmSettingsPanel::isForAll() const
{
    return m_forAll->isChecked();
}

} // namespace gorizont
