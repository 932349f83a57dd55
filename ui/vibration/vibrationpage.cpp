#include "ui/vibration/vibrationpage.h"

#include "ui/vibration/capturetext.h"
#include "ui/vibration/vibrationnames.h"
#include "ui/vibration/vibrationplots.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>

#include <algorithm>

namespace gorizont {

using Kind = lvims::Capture::Kind;

VibrationPage::VibrationPage(SensorRegistry &registry, WorkerOf worker, const Timing &timing, QWidget *parent)
    : QWidget(parent)
    , m_registry(registry)
    , m_worker(std::move(worker))
    , m_timing(timing)
    , m_capture(new VibrationCapture(this))
    , m_plots(new VibrationPlots(this))
    , m_content(new QStackedWidget(this))
    , m_hint(new QLabel(this))
    , m_modules(new QComboBox(this))
    , m_channels(new QComboBox(this))
    , m_start(new QPushButton(tr("&Capture"), this))
    , m_stop(new QPushButton(tr("S&top"), this))
    , m_repeats(new QCheckBox(tr("&every"), this))
    , m_period(new QSpinBox(this))
    , m_units(new QComboBox(this))
    , m_scales(new QComboBox(this))
    , m_cursors(new QCheckBox(tr("C&ursors"), this))
    , m_save(new QPushButton(tr("S&ave"), this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
{
    setObjectName(QStringLiteral("vibrationPage"));
    build();
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &VibrationPage::capture);
    connect(m_capture, &VibrationCapture::progressed, this, [this](Kind kind, qsizetype done, qsizetype total) {
        m_progress->setRange(0, std::max(1, static_cast<int>(total)));
        m_progress->setValue(static_cast<int>(done));
        say(capturetext::progress(kind, done, total));
    });
    connect(m_capture, &VibrationCapture::captured, this, &VibrationPage::take);
    connect(m_capture, &VibrationCapture::failed, this, &VibrationPage::takeFailure);
    connect(m_capture, &VibrationCapture::finished, this, &VibrationPage::endRound);
    connect(&registry, &SensorRegistry::lineChanged, this, &VibrationPage::refresh);
    connect(&registry, &SensorRegistry::readingsChanged, this, &VibrationPage::refresh);
    choose();
}

/// Nobody is told any more.
VibrationPage::~VibrationPage()
{
    m_capture->disconnect(this);
    m_capture->stop();
}

const SensorConfig *VibrationPage::module() const
{
    const int index = m_registry.indexOf(m_modules->currentData().toInt());
    return index < 0 ? nullptr : &m_registry.sensors()[static_cast<std::size_t>(index)].config;
}

LineState VibrationPage::lineState() const
{
    const SensorConfig *sensor = module();
    const int line = sensor ? m_registry.lineIndexOf(sensor->port) : -1;
    return line < 0 ? LineState::Off : m_registry.lines()[static_cast<std::size_t>(line)].status.state;
}

int VibrationPage::channel() const
{
    return m_channels->currentIndex();
}

/// What was captured belongs to another channel.
void VibrationPage::choose()
{
    stop({});
    m_plots->clear();
    changeView();
    refresh();
}

void VibrationPage::capture()
{
    const SensorConfig *sensor = module();
    LineWorker *worker = sensor && m_worker ? m_worker(sensor->port) : nullptr;
    m_next.stop();
    m_failures.clear();
    m_captured.clear();
    m_begun = std::chrono::steady_clock::now();
    if (!worker || !objection().isEmpty()) {
        endRound(); // a round that is repeated may find the module back
        return;
    }
    m_capture->start(*worker, lvims::Service::of(*sensor, m_timing), channel(), [this] {
        return lineState() == LineState::Open;
    });
    refresh();
}

void VibrationPage::stop(const QString &why)
{
    m_capture->stop();
    m_next.stop();
    m_progress->reset();
    say(why);
    refresh();
}

void VibrationPage::take(const CapturedSignal &signal)
{
    m_plots->show(signal);
    if (signal.kind == Kind::Waveform) {
        m_captured = tr("Captured at %1: %2 samples, %3 a second.")
                         .arg(
                             QTime::currentTime().toString(QStringLiteral("HH:mm:ss")),
                             QString::number(signal.codes.size()), capturetext::number(signal.information.rate));
    }
    if (signal.information.state) {
        if (const QString problem = capturetext::channel(*signal.information.state); !problem.isEmpty()) {
            m_failures.append(problem);
        }
    }
    refresh();
}

void VibrationPage::takeFailure(const CaptureFailure &failure)
{
    m_failures.append(capturetext::failure(failure));
}

void VibrationPage::endRound()
{
    m_progress->reset();
    QStringList texts = m_failures;
    texts.prepend(m_captured);
    texts.removeAll(QString());
    texts.removeDuplicates();
    say(texts.join(u'\n'));
    if (m_repeats->isChecked() && isVisible()) {
        const auto due = m_begun + std::chrono::seconds(m_period->value()) - std::chrono::steady_clock::now();
        m_next.start(std::max(std::chrono::ceil<std::chrono::milliseconds>(due), std::chrono::milliseconds(0)));
    }
    refresh();
}

QString VibrationPage::objection() const
{
    if (!module()) {
        return tr("No sensor of the configuration is an L-VIMS.");
    }
    return capturetext::objection(lineState());
}

QString VibrationPage::channelNote() const
{
    const SensorConfig *sensor = module();
    const int index = sensor ? m_registry.indexOf(sensor->number) : -1;
    if (index < 0) {
        return {};
    }
    const auto &vibration = m_registry.sensors()[static_cast<std::size_t>(index)].reading.vibration;
    return vibration && channel() >= 0 && channel() < vibration->channels.size()
        ? capturetext::channel(vibration->channels.at(channel()))
        : QString();
}

void VibrationPage::say(const QString &text)
{
    m_said = text;
    refresh();
}

/// Also what the registry says of port and channel now.
void VibrationPage::refresh()
{
    const QString problem = objection();
    const bool isRunning = m_capture->isRunning();
    const bool hasAny =
        m_plots->signal(Kind::Waveform) || m_plots->signal(Kind::Spectrum5000) || m_plots->signal(Kind::Spectrum200);
    m_start->setEnabled(problem.isEmpty() && !isRunning);
    m_stop->setEnabled(isRunning || m_next.isActive());
    m_progress->setVisible(isRunning);
    m_save->setEnabled(hasAny);
    m_exports.at(0)->setEnabled(m_plots->signal(Kind::Waveform));
    m_exports.at(1)->setEnabled(m_plots->signal(Kind::Waveform));
    m_exports.at(2)->setEnabled(m_plots->signal(Kind::Spectrum5000));
    m_exports.at(3)->setEnabled(m_plots->signal(Kind::Spectrum200));
    m_hint->setText(
        problem.isEmpty() ? tr("Nothing was captured yet. Choose a channel and press <Capture>.") : problem);
    m_content->setCurrentIndex(hasAny ? 1 : 0);
    QStringList texts{m_said, hasAny && !isRunning ? problem : QString(), channelNote()};
    texts.removeAll(QString());
    texts.removeDuplicates();
    m_state->setText(texts.join(u'\n'));
}

void VibrationPage::changeView()
{
    const auto unit = static_cast<lvims::CodeUnit>(m_units->currentIndex());
    const SensorConfig *sensor = module();
    const QString name = unit == lvims::CodeUnit::Volts ? tr("V")
        : sensor                                        ? vibrationnames::accelerationUnit(*sensor)
                                                        : QString();
    m_plots->setView({unit, name, m_scales->currentIndex() == 1});
}

/// A window that is only covered or minimised goes on; another page ends it.
void VibrationPage::hideEvent(QHideEvent *event)
{
    if (!event->spontaneous() && (m_capture->isRunning() || m_next.isActive())) {
        stop(tr("Stopped, because the page was left."));
    }
    QWidget::hideEvent(event);
}

} // namespace gorizont
