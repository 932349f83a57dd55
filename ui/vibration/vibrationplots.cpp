#include "ui/vibration/vibrationplots.h"

#include "ui/models/colours.h"
#include "ui/models/valuetext.h"
#include "ui/plots/cursorlines.h"
#include "ui/plots/curvestyle.h"
#include "ui/vibration/capturetext.h"
#include "ui/vibration/spectrumplot.h"

#include <QLabel>
#include <QSplitter>

namespace gorizont {

using Kind = lvims::Capture::Kind;

VibrationPlots::VibrationPlots(QWidget *parent)
    : QWidget(parent)
    , m_wave(new ScopePlot(this))
    , m_readings(new QLabel(this))
    , m_peaks(new QLabel(this))
{
    m_wave->setObjectName(QStringLiteral("vibrationWave"));
    m_wave->setAccessibleName(tr("Waveform"));
    m_wave->addGraph();
    m_wave->xAxis->setLabel(tr("Time, s"));
    m_to5000 = makeSpectrum(tr("of the module, to 5000 Hz"), 5000, "vibrationTo5000", tr("Spectrum up to 5000 Hz"));
    m_to200 = makeSpectrum(tr("of the module, to 200 Hz"), 200, "vibrationTo200", tr("Spectrum up to 200 Hz"));
    auto *spectra = new QSplitter(Qt::Horizontal);
    spectra->setObjectName(QStringLiteral("vibrationSpectra"));
    spectra->addWidget(m_to5000);
    spectra->addWidget(m_to200);
    auto *parts = new QSplitter(Qt::Vertical, this);
    parts->setObjectName(QStringLiteral("vibrationParts"));
    parts->addWidget(m_wave);
    parts->addWidget(spectra);
    for (QSplitter *splitter : {spectra, parts}) {
        splitter->setChildrenCollapsible(false);
    }
    for (QLabel *label : {m_readings, m_peaks}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setMargin(2);
    }
    m_readings->setObjectName(QStringLiteral("cursorReadings"));
    m_readings->hide();
    m_peaks->setObjectName(QStringLiteral("vibrationPeaks"));
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(parts, 1);
    rows->addWidget(m_readings);
    rows->addWidget(m_peaks);
    setFocusProxy(m_wave);
    m_cursors = {addCursors(m_wave), addCursors(m_to5000), addCursors(m_to200)};
    connect(&m_analysis, &QFutureWatcherBase::finished, this, [this] {
        if (!m_analysis.isCanceled() && m_analysis.future().resultCount() > 0) {
            m_own = m_analysis.result();
            drawSpectra();
        }
    });
    dress();
}

SpectrumPlot *VibrationPlots::makeSpectrum(
    const QString &name, double highest, const char *objectName, const QString &title)
{
    auto *plot = new SpectrumPlot(name, highest);
    plot->setObjectName(QLatin1String(objectName));
    plot->setAccessibleName(title);
    return plot;
}

CursorLines *VibrationPlots::addCursors(ScopePlot *plot)
{
    auto *cursors = new CursorLines(plot);
    connect(cursors, &CursorLines::moved, this, &VibrationPlots::read);
    return cursors;
}

/// In the colours of the desktop, which may change while the program runs.
void VibrationPlots::dress()
{
    m_wave->graph(0)->setPen(QPen(curveStyle(0, colours::isDark(palette())).colour, 1));
}

void VibrationPlots::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        dress();
    }
}

const CapturedSignal *VibrationPlots::signal(Kind kind) const
{
    const auto found = m_signals.find(kind);
    return found == m_signals.end() ? nullptr : &found->second;
}

void VibrationPlots::setView(const View &view)
{
    m_view = view;
    drawWaveform();
    analyse();
    drawSpectra();
    read();
}

void VibrationPlots::show(const CapturedSignal &signal)
{
    m_signals[signal.kind] = signal;
    if (signal.kind == Kind::Waveform) {
        drawWaveform();
        analyse();
    } else {
        drawSpectra();
    }
    read();
}

void VibrationPlots::clear()
{
    m_signals.clear();
    m_own = {};
    m_analysis.setFuture({});
    drawWaveform();
    drawSpectra();
    read();
}

void VibrationPlots::drawWaveform()
{
    m_wave->yAxis->setLabel(
        m_view.unit == lvims::CodeUnit::Volts ? tr("Voltage, %1").arg(m_view.unitName)
                                              : tr("Acceleration, %1").arg(m_view.unitName));
    QVector<QCPGraphData> points;
    if (const CapturedSignal *wave = signal(Kind::Waveform)) {
        points.reserve(wave->codes.size());
        for (qsizetype i = 0; i < wave->codes.size(); ++i) {
            points.append({wave->information.time(i), wave->information.value(wave->codes.at(i), m_view.unit)});
        }
        m_wave->setWhole({0, wave->information.time(wave->codes.size())});
    }
    m_wave->graph(0)->data()->set(points, true);
    m_wave->fit();
}

void VibrationPlots::analyse()
{
    if (const CapturedSignal *wave = signal(Kind::Waveform)) {
        m_analysis.cancel();
        m_analysis.setFuture(ownSpectrumLater(wave->information, wave->codes, m_view.unit));
    }
}

VibrationSpectrum VibrationPlots::module(Kind kind) const
{
    const CapturedSignal *spectrum = signal(kind);
    return spectrum ? spectrumOfModule(spectrum->information, spectrum->codes, m_view.unit) : VibrationSpectrum();
}

void VibrationPlots::drawSpectra()
{
    const VibrationSpectrum to5000 = module(Kind::Spectrum5000);
    const VibrationSpectrum to200 = module(Kind::Spectrum200);
    m_to5000->showSpectra(to5000, m_own, m_view.unitName, m_view.isDensity);
    m_to200->showSpectra(to200, m_own, m_view.unitName, m_view.isDensity);
    QStringList texts{
        capturetext::peaks(tr("Peaks of the waveform, %1").arg(m_view.unitName), m_own.peaks),
        capturetext::peaks(tr("of the module, to 5000 Hz"), to5000.peaks),
        capturetext::peaks(tr("of the module, to 200 Hz"), to200.peaks)};
    texts.removeAll(QString());
    m_peaks->setText(texts.join(u'\n'));
    read();
}

void VibrationPlots::setCursorsShown(bool isShown)
{
    m_readings->setVisible(isShown);
    for (CursorLines *cursors : m_cursors) {
        cursors->setShown(isShown);
    }
}

void VibrationPlots::showWhole()
{
    for (ScopePlot *plot : {m_wave, static_cast<ScopePlot *>(m_to5000), static_cast<ScopePlot *>(m_to200)}) {
        plot->showWhole();
    }
}

QString VibrationPlots::readWaveform() const
{
    const CursorLines &cursors = *m_cursors.constFirst();
    const CapturedSignal *wave = signal(Kind::Waveform);
    const auto at = [&](double key) -> std::optional<double> {
        const qsizetype sample = wave ? qRound64(key * wave->information.rate) : -1;
        return sample >= 0 && wave && sample < wave->codes.size()
            ? std::optional(wave->information.value(wave->codes.at(sample), m_view.unit))
            : std::nullopt;
    };
    const auto text = [](std::optional<double> value) {
        return value ? capturetext::number(*value) : valuetext::absent();
    };
    const auto a = at(cursors.firstKey());
    const auto b = at(cursors.secondKey());
    const double length = cursors.secondKey() - cursors.firstKey();
    const QString frequency = length == 0 ? valuetext::absent() : capturetext::number(1 / std::abs(length));
    return tr("Waveform: A %1 s: %2; B %3 s: %4; B − A %5 s (1/T = %6 Hz): %7 %8")
        .arg(
            QString::number(cursors.firstKey(), 'f', 5), text(a), QString::number(cursors.secondKey(), 'f', 5), text(b),
            QString::number(length, 'f', 5), frequency, text(a && b ? std::optional(*b - *a) : std::nullopt),
            m_view.unitName);
}

QString VibrationPlots::readSpectrum(const SpectrumPlot &plot, const CursorLines &cursors, const QString &name) const
{
    return tr("%1 (module | waveform): A %2 Hz: %3; B %4 Hz: %5; B − A %6 Hz")
        .arg(
            name, QString::number(cursors.firstKey(), 'f', 3), plot.valuesAt(cursors.firstKey()),
            QString::number(cursors.secondKey(), 'f', 3), plot.valuesAt(cursors.secondKey()),
            QString::number(cursors.secondKey() - cursors.firstKey(), 'f', 3));
}

void VibrationPlots::read()
{
    if (m_cursors.size() == 3 && m_cursors.constFirst()->isShown()) {
        m_readings->setText(QStringList{
            readWaveform(), readSpectrum(*m_to5000, *m_cursors.at(1), m_to5000->accessibleName()),
            readSpectrum(*m_to200, *m_cursors.at(2), m_to200->accessibleName())}
                                .join(u'\n'));
    }
}

} // namespace gorizont
