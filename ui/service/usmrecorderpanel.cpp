#include "ui/service/usmrecorderpanel.h"

#include <QCheckBox>
#include <QDateTimeEdit>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

namespace gorizont {

namespace {

QSpinBox *makeSpin(const QString &objectName, int least, int most, QWidget *parent)
{
    auto *spin = new QSpinBox(parent);
    spin->setObjectName(objectName);
    spin->setRange(least, most);
    return spin;
}

QLabel *labelFor(const QString &text, QWidget *field)
{
    auto *label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    return label;
}

/// At least a minute away.
QDateTime nextFullHour()
{
    constexpr int minute = 60;
    constexpr int hour = 3600;
    const qint64 later = QDateTime::currentSecsSinceEpoch() + minute;
    return QDateTime::fromSecsSinceEpoch((later / hour + 1) * hour);
}

} // namespace

UsmRecorderPanel::UsmRecorderPanel(QWidget *parent)
    : QWidget(parent)
    , m_forAll(new QCheckBox(tr("For all devices on the line (none of them answers)"), this))
{
    m_forAll->setObjectName(QStringLiteral("recorderForAll"));
    auto *hint = new QLabel(
        tr("A recorder sleeps, measures by its clock and answers nobody; polling shows it as one that does not answer. "
           "More than a minute without power ends this mode too."),
        this);
    hint->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(hint);
    layout->addWidget(makeStart());
    layout->addWidget(makeWake());
    layout->addWidget(m_forAll);
    layout->addStretch(1);
    connect(m_forAll, &QCheckBox::toggled, this, &UsmRecorderPanel::chosen);
    connect(m_start, &QPushButton::clicked, this, &UsmRecorderPanel::startWanted);
    connect(m_wake, &QPushButton::clicked, this, [this] {
        if (m_isWaking) {
            Q_EMIT wakingStopped();
        } else {
            Q_EMIT wakeWanted();
        }
    });
    showWaking({});
}

QWidgetList UsmRecorderPanel::tabOrder() const
{
    return {m_first, m_period, m_delay, m_start, m_address, m_wake, m_forAll};
}

QGroupBox *UsmRecorderPanel::makeStart()
{
    auto *group = new QGroupBox(tr("Recorder mode"), this);
    m_first = new QDateTimeEdit(nextFullHour(), group);
    m_first->setObjectName(QStringLiteral("firstMeasurement"));
    m_first->setDisplayFormat(QStringLiteral("dd.MM.yyyy HH:mm"));
    m_period = makeSpin(
        QStringLiteral("recorderPeriod"), static_cast<int>(usmisn::shortestPeriod.count()),
        static_cast<int>(usmisn::longestPeriod.count()), group);
    m_period->setSingleStep(static_cast<int>(usmisn::shortestPeriod.count()));
    m_period->setValue(static_cast<int>(usmisn::Recording().period.count()));
    m_delay = makeSpin(QStringLiteral("recorderDelay"), 0, static_cast<int>(usmisn::longestDelay.count()), group);
    m_delay->setToolTip(tr("So that several devices do not measure at the same time"));
    m_start = new QPushButton(tr("&Begin to record"), group);
    m_start->setObjectName(QStringLiteral("startCycle"));
    m_start->setAutoDefault(false);
    auto *grid = new QGridLayout(group);
    grid->addWidget(labelFor(tr("First measurement (local time):"), m_first), 0, 0);
    grid->addWidget(m_first, 0, 1);
    grid->addWidget(labelFor(tr("Period, s:"), m_period), 1, 0);
    grid->addWidget(m_period, 1, 1);
    grid->addWidget(labelFor(tr("Delay before each, s:"), m_delay), 2, 0);
    grid->addWidget(m_delay, 2, 1);
    grid->addWidget(m_start, 2, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

QGroupBox *UsmRecorderPanel::makeWake()
{
    auto *group = new QGroupBox(tr("End of the recorder mode"), this);
    m_address = makeSpin(QStringLiteral("wakeAddress"), 1, 255, group);
    m_progress = new QProgressBar(group);
    m_progress->setObjectName(QStringLiteral("wakeProgress"));
    m_progress->setTextVisible(false);
    m_wake = new QPushButton(group);
    m_wake->setObjectName(QStringLiteral("stopCycle"));
    m_wake->setAutoDefault(false);
    m_wake->setToolTip(tr("A recorder listens now and then for a second: this takes up to two minutes."));
    auto *grid = new QGridLayout(group);
    grid->addWidget(labelFor(tr("Address of the recorder:"), m_address), 0, 0);
    grid->addWidget(m_address, 0, 1);
    grid->addWidget(m_progress, 0, 2);
    grid->addWidget(m_wake, 0, 3);
    grid->setColumnStretch(2, 1);
    return group;
}

/// What the field shows has no seconds.
usmisn::Recording UsmRecorderPanel::recording(qint64 now) const
{
    return {
        now, m_first->dateTime().toSecsSinceEpoch(), std::chrono::seconds(m_period->value()),
        std::chrono::seconds(m_delay->value())};
}

bool UsmRecorderPanel::isForAll() const
{
    return m_forAll->isChecked();
}

int UsmRecorderPanel::wakeAddress() const
{
    return m_address->value();
}

void UsmRecorderPanel::setWakeAddress(int address)
{
    m_address->setValue(address);
}

void UsmRecorderPanel::setControls(bool isReady, bool isShown)
{
    for (QWidget *widget : std::initializer_list<QWidget *>{m_first, m_period, m_delay, m_start}) {
        widget->setEnabled(isShown || (isReady && isForAll()));
    }
    m_address->setEnabled(isReady && !isForAll());
    m_forAll->setEnabled(isReady);
    m_wake->setEnabled(isReady || m_isWaking);
}

void UsmRecorderPanel::showWaking(std::optional<int> percent)
{
    m_isWaking = percent.has_value();
    m_progress->setValue(percent.value_or(0));
    m_wake->setText(m_isWaking ? tr("Sto&p") : tr("&Wake"));
}

} // namespace gorizont
