#include "ui/service/ind3form.h"

#include "ui/models/valuetext.h"
#include "ui/service/servicetext.h"
#include "ui/service/valuelabel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>

#include <cmath>

namespace gorizont {

namespace {

constexpr int decimals = 3; ///< of the offsets, as on the picture of the manual

/// The field shows fewer digits than the sensor has: as long as nobody typed anything else, the value is the sensor's own.
std::optional<double> typed(const QLineEdit &field, double own)
{
    const auto value = servicetext::number(field.text());
    return value && valuetext::fixed(*value, decimals) == valuetext::fixed(own, decimals) ? own : value;
}

QLabel *labelFor(const QString &text, QWidget *field)
{
    auto *label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    return label;
}

} // namespace

Ind3Form::Ind3Form(QComboBox *addresses, QPushButton *change, QComboBox *protocols, QWidget *parent)
    : QWidget(parent)
    , m_exchangeOrder({addresses, change})
{
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeExchange(addresses, change, protocols), 0, 0);
    layout->addWidget(makeAbout(), 0, 1);
    layout->addWidget(makeMeasuring(), 1, 0, 1, 2);
    layout->setColumnStretch(0, 3);
    layout->setColumnStretch(1, 2);
    m_exchangeOrder << m_name << protocols;
    for (QLineEdit *field : {m_name, m_offsetX, m_offsetY}) {
        connect(field, &QLineEdit::textEdited, this, &Ind3Form::onEdited);
    }
    for (QComboBox *list : {m_ticks, m_period}) {
        connect(list, &QComboBox::activated, this, &Ind3Form::onEdited);
    }
    clear();
}

QWidgetList Ind3Form::tabOrder() const
{
    return m_exchangeOrder + QWidgetList{m_offsetX, m_ticks, m_offsetY, m_period};
}

QGroupBox *Ind3Form::makeExchange(QComboBox *addresses, QPushButton *change, QComboBox *protocols)
{
    auto *group = new QGroupBox(tr("Exchange"), this);
    for (QWidget *widget : std::initializer_list<QWidget *>{addresses, change, protocols}) {
        widget->setParent(group);
    }
    m_name = new QLineEdit(group);
    m_name->setObjectName(QStringLiteral("nameEdit"));
    m_name->setMaxLength(static_cast<int>(ind3::longestName));
    m_name->setToolTip(tr("Up to %1 characters: Latin, Cyrillic, digits and signs. The sensor keeps the name.")
                           .arg(ind3::longestName));
    m_baud = valueLabel(QStringLiteral("sensorSpeed"), QStringLiteral("115200"), group);
    m_baud->setToolTip(tr("The speed is shown only; this program does not change it."));
    auto *grid = new QGridLayout(group);
    grid->addWidget(labelFor(tr("&Address on the line:"), addresses), 0, 0);
    grid->addWidget(addresses, 0, 1);
    grid->addWidget(change, 0, 2);
    grid->addWidget(labelFor(tr("&Name of the sensor:"), m_name), 1, 0);
    grid->addWidget(m_name, 1, 1, 1, 2);
    grid->addWidget(new QLabel(tr("Speed:"), group), 2, 0);
    grid->addWidget(m_baud, 2, 1);
    grid->addWidget(labelFor(tr("&Protocol:"), protocols), 3, 0);
    grid->addWidget(protocols, 3, 1);
    grid->setColumnStretch(1, 1);
    return group;
}

QGroupBox *Ind3Form::makeAbout()
{
    auto *group = new QGroupBox(tr("About the device"), this);
    m_version = valueLabel(QStringLiteral("sensorVersion"), QStringLiteral("v2.11"), group);
    m_revision = valueLabel(QStringLiteral("softwareRevision"), QStringLiteral("65535"), group);
    m_serialNumber = valueLabel(QStringLiteral("factoryNumber"), QStringLiteral("4294967295"), group);
    auto *grid = new QGridLayout(group);
    grid->addWidget(new QLabel(tr("Version of the sensor:"), group), 0, 0);
    grid->addWidget(m_version, 0, 1);
    grid->addWidget(new QLabel(tr("Software revision:"), group), 1, 0);
    grid->addWidget(m_revision, 1, 1);
    grid->addWidget(new QLabel(tr("Factory number:"), group), 2, 0);
    grid->addWidget(m_serialNumber, 2, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(3, 1);
    return group;
}

QLineEdit *Ind3Form::makeOffset(const QString &objectName)
{
    auto *field = new QLineEdit(this);
    field->setObjectName(objectName);
    field->setToolTip(tr("Arc-seconds, from −%1 to +%1. Point and comma are both decimal marks.")
                          .arg(valuetext::fixed(largestOffset, 2)));
    return field;
}

QGroupBox *Ind3Form::makeMeasuring()
{
    auto *group = new QGroupBox(tr("Measuring"), this);
    m_offsetX = makeOffset(QStringLiteral("offsetXEdit"));
    m_offsetY = makeOffset(QStringLiteral("offsetYEdit"));
    m_ticks = new QComboBox(group);
    m_ticks->setObjectName(QStringLiteral("ticksCombo"));
    for (int code = 0; code <= ind3::mostTicksCode; ++code) {
        m_ticks->addItem(QString::number(*ind3::ticksOfCode(code)), *ind3::ticksOfCode(code));
    }
    m_period = new QComboBox(group);
    m_period->setObjectName(QStringLiteral("periodCombo"));
    for (int code = 0; code <= ind3::mostPeriodCode; ++code) {
        const int period = static_cast<int>(ind3::periodOfCode(code)->count());
        m_period->addItem(QString::number(period), period);
    }
    m_tilt = valueLabel(QStringLiteral("liveTilt"), QStringLiteral("-16383.9 -16383.9"), group);
    m_problem = new QLabel(group);
    m_problem->setObjectName(QStringLiteral("formProblem"));
    m_problem->setWordWrap(true);
    m_problem->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing moves when it has something to say
    auto *grid = new QGridLayout(group);
    grid->addWidget(labelFor(tr("Zero offset &X, ″:"), m_offsetX), 0, 0);
    grid->addWidget(m_offsetX, 0, 1);
    grid->addWidget(labelFor(tr("Averaging &ticks:"), m_ticks), 0, 2);
    grid->addWidget(m_ticks, 0, 3);
    grid->addWidget(labelFor(tr("Zero offset &Y, ″:"), m_offsetY), 1, 0);
    grid->addWidget(m_offsetY, 1, 1);
    grid->addWidget(labelFor(tr("Averaging p&eriod, ms:"), m_period), 1, 2);
    grid->addWidget(m_period, 1, 3);
    grid->addWidget(new QLabel(tr("Tilt X, Y now, ″:"), group), 2, 0);
    grid->addWidget(m_tilt, 2, 1);
    grid->addWidget(m_problem, 2, 2, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return group;
}

void Ind3Form::showSettings(const ind3::Settings &settings)
{
    m_settings = settings;
    const QString none = valuetext::absent();
    m_name->setText(settings.name.value_or(none));
    m_baud->setText(QString::number(settings.baud));
    m_version->setText(settings.version.isEmpty() ? none : settings.version);
    m_revision->setText(QString::number(settings.revision.number));
    m_revision->setToolTip(tr("Type %1, revision %2").arg(settings.revision.type()).arg(settings.revision.revision()));
    m_serialNumber->setText(QString::number(settings.serialNumber));
    m_offsetX->setText(settings.offset ? valuetext::fixed(settings.offset->x, decimals) : none);
    m_offsetY->setText(settings.offset ? valuetext::fixed(settings.offset->y, decimals) : none);
    m_ticks->setCurrentIndex(m_ticks->findData(settings.ticks));
    m_period->setCurrentIndex(m_period->findData(static_cast<int>(settings.period.count())));
    setEditable(m_isEditable);
}

void Ind3Form::clear()
{
    m_settings.reset();
    for (QLineEdit *field : {m_name, m_offsetX, m_offsetY}) {
        field->clear();
    }
    for (QLabel *label : {m_baud, m_version, m_revision, m_serialNumber, m_tilt}) {
        label->clear();
    }
    m_ticks->setCurrentIndex(-1);
    m_period->setCurrentIndex(-1);
    setEditable(m_isEditable);
}

void Ind3Form::showTilt(const std::optional<Tilt> &tilt)
{
    m_tilt->setText(
        tilt ? valuetext::signedFixed(tilt->x, 1) + u' ' + valuetext::signedFixed(tilt->y, 1) : valuetext::absent());
}

void Ind3Form::setEditable(bool isEditable)
{
    m_isEditable = isEditable;
    m_name->setEnabled(isEditable && m_settings && m_settings->name);
    m_offsetX->setEnabled(isEditable && m_settings && m_settings->offset);
    m_offsetY->setEnabled(m_offsetX->isEnabled());
    m_ticks->setEnabled(isEditable && m_settings);
    m_period->setEnabled(m_ticks->isEnabled());
    m_problem->setText(problem());
}

void Ind3Form::onEdited()
{
    m_problem->setText(problem());
    Q_EMIT edited();
}

bool Ind3Form::isOffsetEdited() const
{
    return m_settings && m_settings->offset
        && Tilt{typed(*m_offsetX, m_settings->offset->x).value_or(NAN), typed(*m_offsetY, m_settings->offset->y).value_or(NAN)}
        != *m_settings->offset;
}

std::optional<Tilt> Ind3Form::typedOffset() const
{
    const auto x = typed(*m_offsetX, m_settings->offset->x);
    const auto y = typed(*m_offsetY, m_settings->offset->y);
    const bool isGood = x && y && std::abs(*x) <= largestOffset && std::abs(*y) <= largestOffset;
    return isGood ? std::optional(Tilt{*x, *y}) : std::nullopt;
}

ind3::Changes Ind3Form::changes() const
{
    ind3::Changes changes;
    if (!m_settings) {
        return changes;
    }
    if (m_settings->name && m_name->text() != *m_settings->name && ind3::encodeName(m_name->text())) {
        changes.name = m_name->text();
    }
    if (isOffsetEdited()) {
        changes.offset = typedOffset();
    }
    if (m_ticks->currentIndex() >= 0 && m_ticks->currentData().toInt() != m_settings->ticks) {
        changes.ticks = m_ticks->currentData().toInt();
    }
    const std::chrono::milliseconds period(m_period->currentData().toInt());
    if (m_period->currentIndex() >= 0 && period != m_settings->period) {
        changes.period = period;
    }
    return changes;
}

bool Ind3Form::isEdited() const
{
    return !changes().isEmpty() || !problem().isEmpty();
}

QString Ind3Form::problem() const
{
    if (!m_settings) {
        return {};
    }
    if (m_settings->name && m_name->text() != *m_settings->name && !ind3::encodeName(m_name->text())) {
        return tr("The name needs 1…%1 characters: Latin, Cyrillic, digits and signs.").arg(ind3::longestName);
    }
    if (isOffsetEdited() && !typedOffset()) {
        return tr("An offset is a number from −%1 to +%1.").arg(valuetext::fixed(largestOffset, 2));
    }
    return {};
}

} // namespace gorizont
