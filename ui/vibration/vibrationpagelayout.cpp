// What the page <Вибрация> is made of, and the files that it writes; how it behaves stands in vibrationpage.cpp.

#include "core/devices/lvims/lvimsfiles.h"
#include "core/files/wholefile.h"
#include "ui/vibration/vibrationnames.h"
#include "ui/vibration/vibrationpage.h"
#include "ui/vibration/vibrationplots.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>

namespace gorizont {

using Kind = lvims::Capture::Kind;

namespace {

Kind kindOf(VibrationPage::Export form)
{
    switch (form) {
    case VibrationPage::Export::WaveformCsv:
    case VibrationPage::Export::WaveformWav: break;
    case VibrationPage::Export::Spectrum5000Csv: return Kind::Spectrum5000;
    case VibrationPage::Export::Spectrum200Csv: return Kind::Spectrum200;
    }
    return Kind::Waveform;
}

QByteArray fileOf(const CapturedSignal &signal, VibrationPage::Export form)
{
    switch (form) {
    case VibrationPage::Export::WaveformCsv: return lvims::waveformCsv(signal.information, signal.codes);
    case VibrationPage::Export::WaveformWav: return lvims::waveformWav(signal.information, signal.codes);
    case VibrationPage::Export::Spectrum5000Csv:
    case VibrationPage::Export::Spectrum200Csv: break;
    }
    return lvims::spectrumCsv(signal.information, signal.codes);
}

QLabel *labelFor(QWidget *buddy, const QString &text)
{
    auto *label = new QLabel(text, buddy->parentWidget());
    label->setBuddy(buddy);
    return label;
}

} // namespace

void VibrationPage::build()
{
    auto *capturing = new QHBoxLayout;
    buildCapturing(*capturing);
    auto *viewing = new QHBoxLayout;
    buildViewing(*viewing);
    m_hint->setObjectName(QStringLiteral("vibrationHint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_content->addWidget(m_hint);
    m_content->addWidget(m_plots);
    m_state->setObjectName(QStringLiteral("vibrationState"));
    m_state->setWordWrap(true);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_state->setMargin(2);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(4, 4, 4, 0);
    rows->addLayout(capturing);
    rows->addLayout(viewing);
    rows->addWidget(m_content, 1);
    rows->addWidget(m_state);
    setFocusProxy(m_modules);
}

void VibrationPage::buildCapturing(QHBoxLayout &row)
{
    m_modules->setObjectName(QStringLiteral("vibrationModule"));
    m_channels->setObjectName(QStringLiteral("vibrationChannel"));
    m_start->setObjectName(QStringLiteral("vibrationCapture"));
    m_start->setToolTip(tr("The waveform and both spectra of the module. Polling goes on meanwhile."));
    m_stop->setObjectName(QStringLiteral("vibrationStop"));
    m_repeats->setObjectName(QStringLiteral("vibrationRepeats"));
    m_period->setObjectName(QStringLiteral("vibrationPeriod"));
    m_progress->setObjectName(QStringLiteral("vibrationProgress"));
    for (const SensorRegistry::Sensor &sensor : m_registry.sensors()) {
        if (sensor.config.type == SensorType::LVims) {
            m_modules->addItem(
                QStringLiteral("%1  %2").arg(sensor.config.number).arg(sensor.config.name), sensor.config.number);
        }
    }
    for (int channel = 0; channel < lvims::channelCount; ++channel) {
        m_channels->addItem(QString::number(channel));
    }
    m_period->setRange(1, 3600);
    m_period->setValue(10);
    m_period->setSuffix(QStringLiteral(" ") + tr("s"));
    m_period->setAccessibleName(tr("Seconds from one capture to the next"));
    m_progress->setTextVisible(false);
    row.addWidget(labelFor(m_modules, tr("&Module:")));
    row.addWidget(m_modules);
    row.addWidget(labelFor(m_channels, tr("Cha&nnel:")));
    for (QWidget *widget : std::initializer_list<QWidget *>{m_channels, m_start, m_stop, m_repeats, m_period}) {
        row.addWidget(widget);
    }
    row.addWidget(m_progress, 1);
    row.addStretch(0);
    connect(m_modules, &QComboBox::currentIndexChanged, this, &VibrationPage::choose);
    connect(m_channels, &QComboBox::currentIndexChanged, this, &VibrationPage::choose);
    connect(m_start, &QPushButton::clicked, this, &VibrationPage::capture);
    connect(m_stop, &QPushButton::clicked, this, [this] { stop(tr("Stopped.")); });
    connect(m_repeats, &QCheckBox::toggled, this, [this](bool repeats) {
        if (!repeats) {
            m_next.stop();
            refresh();
        }
    });
}

void VibrationPage::buildViewing(QHBoxLayout &row)
{
    m_units->setObjectName(QStringLiteral("vibrationUnit"));
    m_units->addItems({tr("physical units"), tr("volts")});
    m_scales->setObjectName(QStringLiteral("vibrationScale"));
    m_scales->addItems({tr("amplitude"), tr("density")});
    m_cursors->setObjectName(QStringLiteral("vibrationCursors"));
    m_cursors->setToolTip(tr("Two cursors in each plot: drag them, or Ctrl and Shift with the arrows"));
    auto *whole = new QPushButton(tr("&Whole"), this);
    whole->setObjectName(QStringLiteral("vibrationWhole"));
    whole->setToolTip(tr("Shows all of each plot; the wheel and + − zoom, dragging and the arrows move"));
    m_save->setObjectName(QStringLiteral("vibrationSave"));
    auto *menu = new QMenu(m_save);
    buildSaving(*menu);
    m_save->setMenu(menu);
    row.addWidget(labelFor(m_units, tr("&In:")));
    row.addWidget(m_units);
    row.addWidget(labelFor(m_scales, tr("S&pectra:")));
    for (QWidget *widget : std::initializer_list<QWidget *>{m_scales, m_cursors, whole, m_save}) {
        row.addWidget(widget);
    }
    row.addStretch(1);
    connect(m_units, &QComboBox::currentIndexChanged, this, &VibrationPage::changeView);
    connect(m_scales, &QComboBox::currentIndexChanged, this, &VibrationPage::changeView);
    connect(m_cursors, &QCheckBox::toggled, m_plots, &VibrationPlots::setCursorsShown);
    connect(whole, &QPushButton::clicked, m_plots, &VibrationPlots::showWhole);
}

void VibrationPage::buildSaving(QMenu &menu)
{
    const auto add = [&](const QString &text, Export form) {
        m_exports.append(menu.addAction(text, this, [this, form] { askExport(form); }));
    };
    add(tr("Waveform as a table (CSV)…"), Export::WaveformCsv);
    add(tr("Waveform as sound (WAV)…"), Export::WaveformWav);
    add(tr("Spectrum up to 5000 Hz as a table (CSV)…"), Export::Spectrum5000Csv);
    add(tr("Spectrum up to 200 Hz as a table (CSV)…"), Export::Spectrum200Csv);
}

QString VibrationPage::exportTo(const QString &path, Export form) const
{
    const CapturedSignal *signal = m_plots->signal(kindOf(form));
    if (!signal) {
        return tr("Nothing was captured yet.");
    }
    const QString problem = writeWholeFile(path, fileOf(*signal, form));
    return problem.isEmpty() ? QString() : tr("The file was not written (%1). Choose another folder.").arg(problem);
}

/// Returns at once; the file is written when a name has been chosen.
void VibrationPage::askExport(Export form)
{
    const QString suffix = form == Export::WaveformWav ? QStringLiteral("wav") : QStringLiteral("csv");
    auto *dialog = new QFileDialog(this, tr("Save what was captured"));
    dialog->setObjectName(QStringLiteral("vibrationFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(QStringLiteral("*.") + suffix);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this, [this, form](const QString &path) {
        const QString problem = exportTo(path, form);
        say(problem.isEmpty() ? tr("Saved as %1.").arg(path) : problem);
    });
    dialog->open();
}

} // namespace gorizont
