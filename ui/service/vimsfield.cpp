#include "ui/service/vimsfield.h"

#include "ui/vibration/vibrationnames.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSpinBox>

namespace gorizont {

using namespace lvims;

namespace {

/// The widest that an editor of numbers needs.
int numberWidth(const QWidget &widget)
{
    return widget.fontMetrics().horizontalAdvance(QStringLiteral("000000000.0")) + widget.fontMetrics().height();
}

} // namespace

VimsField::VimsField(const Setting &setting, QWidget *parent)
    : QObject(parent)
    , m_setting(setting)
{
    makeEditor(parent);
    m_editor->setObjectName(setting.name);
    m_editor->setAccessibleName(setting.name);
}

void VimsField::makeEditor(QWidget *parent)
{
    switch (m_setting.kind) {
    case Setting::Kind::ChannelMask: makeMask(parent); return;
    case Setting::Kind::MeasurementType: makeTypes(parent); return;
    case Setting::Kind::Switch:
        m_editor = m_switch = new QCheckBox(parent);
        connect(m_switch, &QCheckBox::toggled, this, &VimsField::edited);
        return;
    case Setting::Kind::Milliseconds:
        m_editor = m_number = new QSpinBox(parent);
        m_number->setRange(shortestWaveform, longestWaveform);
        m_number->setSuffix(QStringLiteral(" ") + tr("ms"));
        connect(m_number, &QSpinBox::valueChanged, this, &VimsField::edited);
        return;
    case Setting::Kind::Text:
    case Setting::Kind::Host:
    case Setting::Kind::NetworkMask:
    case Setting::Kind::Gateway:
    case Setting::Kind::Real:
    case Setting::Kind::Frequency: break;
    }
    m_editor = m_line = new QLineEdit(parent);
    if (m_setting.kind == Setting::Kind::Real || m_setting.kind == Setting::Kind::Frequency) {
        m_line->setMaximumWidth(numberWidth(*m_line));
        m_line->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
    }
    connect(m_line, &QLineEdit::textChanged, this, &VimsField::edited);
}

void VimsField::makeMask(QWidget *parent)
{
    m_editor = new QWidget(parent);
    auto *row = new QHBoxLayout(m_editor);
    row->setContentsMargins(0, 0, 0, 0);
    for (int channel = 0; channel < channelCount; ++channel) {
        auto *box = new QCheckBox(QString::number(channel), m_editor);
        box->setObjectName(QStringLiteral("%1.%2").arg(m_setting.name).arg(channel));
        box->setAccessibleName(box->objectName());
        connect(box, &QCheckBox::toggled, this, &VimsField::edited);
        row->addWidget(box);
        m_channels.append(box);
    }
    row->addStretch(1);
    m_editor->setFocusProxy(m_channels.constFirst());
}

void VimsField::makeTypes(QWidget *parent)
{
    m_editor = m_types = new QComboBox(parent);
    for (int type = 0; type <= lastMeasurementType; ++type) {
        m_types->addItem(vibrationnames::measurement(type), type);
    }
    // The names are longer than a column; the open list shows them whole.
    m_types->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_types->setMinimumContentsLength(28);
    connect(m_types, &QComboBox::currentIndexChanged, this, [this] {
        m_types->setToolTip(m_types->currentText());
        Q_EMIT edited();
    });
}

void VimsField::setText(const QString &text)
{
    if (m_line) {
        m_line->setText(text);
        m_line->setCursorPosition(0);
    } else if (m_number) {
        m_number->setValue(text.toInt());
    } else if (m_switch) {
        m_switch->setChecked(text.toInt() != 0);
    } else if (m_types) {
        while (m_types->count() > lastMeasurementType + 1) {
            m_types->removeItem(m_types->count() - 1);
        }
        if (m_types->findData(text.toInt()) < 0) { // a module newer than the manual
            m_types->addItem(vibrationnames::measurement(text.toInt()), text.toInt());
        }
        m_types->setCurrentIndex(m_types->findData(text.toInt()));
    }
    for (qsizetype channel = 0; channel < m_channels.size(); ++channel) {
        m_channels.at(channel)->setChecked((text.toInt() >> channel & 1) != 0);
    }
}

QString VimsField::text() const
{
    if (m_line) {
        return m_line->text();
    }
    if (m_number) {
        return QString::number(m_number->value());
    }
    if (m_switch) {
        return QString::number(int(m_switch->isChecked()));
    }
    if (m_types) {
        return m_types->currentData().toString();
    }
    int mask = 0;
    for (qsizetype channel = 0; channel < m_channels.size(); ++channel) {
        mask |= int(m_channels.at(channel)->isChecked()) << channel;
    }
    return QString::number(mask);
}

void VimsField::show(const QList<quint16> &image)
{
    const QSignalBlocker quiet(this);
    setText(image.isEmpty() ? QString() : valueOf(image, m_setting));
    m_shown = text();
}

/// What nobody touched stays to the last bit as the module has it.
QString VimsField::put(QList<quint16> &image) const
{
    return text() == m_shown ? QString() : change(image, m_setting, text());
}

/// Bold, and the reason in the tool tip: neither needs colours.
void VimsField::compare(const QString &inUse)
{
    const bool isOther = !inUse.isNull();
    QFont font = m_editor->font();
    font.setBold(isOther);
    const QString why = isOther ? tr("%1: in use is %2").arg(m_setting.name, inUse) : m_setting.name;
    m_editor->setFont(font);
    m_editor->setToolTip(why);
    for (QCheckBox *box : m_channels) {
        box->setFont(font);
    }
}

} // namespace gorizont
