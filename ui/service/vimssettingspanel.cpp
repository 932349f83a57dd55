#include "ui/service/vimssettingspanel.h"

#include "ui/service/vimsfield.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QTabWidget>

namespace gorizont {

using namespace lvims;

VimsSettingsPanel::VimsSettingsPanel(QWidget *parent)
    : QWidget(parent)
    , m_told(new QLabel(this))
{
    m_told->setObjectName(QStringLiteral("settingsComplaint"));
    m_told->setWordWrap(true);
    m_told->setMinimumHeight(fontMetrics().lineSpacing());
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeModule());
    layout->addWidget(makeChannels());
    layout->addWidget(m_told);
    layout->addStretch(1);
    setEditable(false);
}

VimsField *VimsSettingsPanel::field(const QString &name, QWidget *parent)
{
    auto *made = new VimsField(*settingNamed(name), parent);
    connect(made, &VimsField::edited, this, &VimsSettingsPanel::take);
    m_fields.append(made);
    return made;
}

QGroupBox *VimsSettingsPanel::makeModule()
{
    auto *group = new QGroupBox(tr("Module"), this);
    auto *grid = new QGridLayout(group);
    const auto add = [&](const QString &name, const QString &title, int row, int column, int columns = 1) {
        QWidget *editor = field(name, group)->editor();
        auto *label = new QLabel(title, group);
        label->setBuddy(editor);
        grid->addWidget(label, row, column);
        grid->addWidget(editor, row, column + 1, 1, columns);
    };
    add(QStringLiteral("CUSTOM_NAME"), tr("Name:"), 0, 0, 3);
    add(QStringLiteral("IP_ADDR"), tr("IP address:"), 1, 0);
    add(QStringLiteral("IP_MASK"), tr("Mask:"), 2, 0);
    add(QStringLiteral("IP_GATE"), tr("Gateway:"), 3, 0);
    add(QStringLiteral("WF_ACQ_TIME"), tr("Length of a waveform:"), 1, 2);
    add(QStringLiteral("CH_EN_MASK"), tr("Channels that measure:"), 2, 2);
    add(QStringLiteral("CH_SENS_PWR"), tr("Sensors that are fed:"), 3, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return group;
}

QTabWidget *VimsSettingsPanel::makeChannels()
{
    m_channels = new QTabWidget(this);
    m_channels->setObjectName(QStringLiteral("channelTabs"));
    for (int channel = 0; channel < channelCount; ++channel) {
        m_channels->addTab(makeChannel(channel, m_channels), tr("Channel %1").arg(channel));
    }
    return m_channels;
}

QWidget *VimsSettingsPanel::makeChannel(int channel, QWidget *parent)
{
    auto *page = new QWidget(parent);
    const QString prefix = QStringLiteral("CH%1.").arg(channel);
    auto *sensor = new QHBoxLayout;
    for (const auto &[name, title] :
         {std::pair(QStringLiteral("SENSOR_K"), tr("Sensor: K, mV/g:")),
          std::pair(QStringLiteral("SENSOR_B"), tr("B, mV/g:"))}) {
        QWidget *editor = field(prefix + name, page)->editor();
        auto *label = new QLabel(title, page);
        label->setBuddy(editor);
        sensor->addWidget(label);
        sensor->addWidget(editor);
    }
    sensor->addStretch(1);
    auto *grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("Measurement"), page), 0, 0, 1, 2);
    grid->addWidget(new QLabel(tr("High-pass, Hz"), page), 0, 2, 1, 2);
    grid->addWidget(new QLabel(tr("Low-pass, Hz"), page), 0, 4, 1, 2);
    for (int m = 0; m < measurementCount; ++m) {
        grid->addWidget(new QLabel(QString::number(m), page), m + 1, 0);
        addMeasurement(*grid, m + 1, prefix + QStringLiteral("MEAS%1").arg(m), page);
    }
    grid->setColumnStretch(1, 1);
    auto *rows = new QVBoxLayout(page);
    rows->addLayout(sensor);
    rows->addLayout(grid);
    return page;
}

void VimsSettingsPanel::addMeasurement(QGridLayout &grid, int row, const QString &name, QWidget *parent)
{
    grid.addWidget(field(name + QStringLiteral(".TYPE"), parent)->editor(), row, 1);
    int column = 2;
    for (const char *filter : {".IIR_HP", ".IIR_LP"}) {
        const QString part = name + QLatin1String(filter);
        grid.addWidget(field(part + QStringLiteral(".EN"), parent)->editor(), row, column++);
        grid.addWidget(field(part + QStringLiteral(".FC"), parent)->editor(), row, column++);
    }
}

QWidgetList VimsSettingsPanel::tabOrder() const
{
    QWidgetList order;
    for (const VimsField *field : m_fields) {
        if (field->setting().name.startsWith(u"CH0.SENSOR_K")) {
            order << m_channels;
        }
        const auto boxes = field->editor()->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly);
        const bool isGroup = field->setting().kind == Setting::Kind::ChannelMask;
        order += isGroup ? boxes : QWidgetList{field->editor()};
    }
    return order;
}

void VimsSettingsPanel::setEditable(bool isEditable)
{
    for (const VimsField *field : m_fields) {
        field->editor()->setEnabled(isEditable);
    }
}

void VimsSettingsPanel::showModule(const QList<quint16> &inUse, const QList<quint16> &prepared)
{
    m_inUse = inUse;
    m_prepared = prepared;
    want(prepared);
}

void VimsSettingsPanel::want(const QList<quint16> &image)
{
    m_base = image;
    for (VimsField *field : m_fields) {
        field->show(image);
    }
    take();
}

bool VimsSettingsPanel::isEdited() const
{
    return !m_complaint.isEmpty() || (!m_prepared.isEmpty() && m_wanted != m_prepared);
}

void VimsSettingsPanel::take()
{
    m_wanted = m_base;
    m_complaint.clear();
    for (VimsField *field : m_fields) {
        const QString problem = m_base.isEmpty() ? QString() : field->put(m_wanted);
        m_complaint = m_complaint.isEmpty() ? problem : m_complaint;
        const QString inUse = m_inUse.isEmpty() ? QString() : valueOf(m_inUse, field->setting());
        const bool isSame = problem.isEmpty() && (m_wanted.isEmpty() || inUse == valueOf(m_wanted, field->setting()));
        field->compare(isSame ? QString() : inUse.isNull() ? QStringLiteral("—") : inUse);
    }
    m_told->setText(m_complaint);
    Q_EMIT edited();
}

} // namespace gorizont
