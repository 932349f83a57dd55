#include "ui/plots/waveformpage.h"

#include "ui/models/colours.h"
#include "ui/plots/curvestyle.h"
#include "ui/plots/plotlook.h"
#include "ui/plots/plottext.h"
#include "ui/plots/plottime.h"
#include "ui/plots/plotting.h"
#include "ui/plots/timeticker.h"

#include <QComboBox>
#include <QToolBar>

#include <limits>

namespace gorizont {

namespace {

constexpr int fullRate = 0;
constexpr double airOfScale = 0.05; ///< above and below the samples
constexpr double leastScale = 1e-3; ///< mm/s²

} // namespace

WaveformPage::WaveformPage(SensorRegistry &registry, SeriesSource source, QWidget *parent, SeriesFeed::Clock clock)
    : SpanPage(registry, std::move(source), {Quantity::SampleX, Quantity::SampleY}, fullRate, parent, std::move(clock))
    , m_content(new QWidget(this))
    , m_wave(new QCustomPlot(m_content))
    , m_lines(new QCustomPlot(m_content))
{
    setObjectName(QStringLiteral("waveformPage"));
    buildPlots();
    buildChoices();
    connect(&m_analysis, &QFutureWatcherBase::finished, this, &WaveformPage::takeAnalysis);
    auto *rows = new QVBoxLayout(m_content);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_wave, 1);
    rows->addWidget(m_lines, 1);
    setContent(
        m_content, tr("No sensor of the configuration measures accelerations."),
        tr("There are no samples in this span. Choose a longer span or another sensor."));
}

void WaveformPage::buildPlots()
{
    m_wave->setObjectName(QStringLiteral("wavePlot"));
    m_wave->setAccessibleName(tr("Samples"));
    m_wave->setFocusPolicy(Qt::StrongFocus);
    setFocusProxy(m_wave);
    m_lines->setObjectName(QStringLiteral("spectrumPlot"));
    m_lines->setAccessibleName(tr("Spectrum"));
    m_wave->xAxis->setTicker(QSharedPointer<TimeTicker>::create());
    const QString unit = plottext::unitOf(ValueAxis::Acceleration, TiltUnit::Degrees);
    m_wave->yAxis->setLabel(plottext::axisTitle(ValueAxis::Acceleration, TiltUnit::Degrees));
    m_lines->xAxis->setLabel(tr("Frequency, Hz"));
    m_lines->yAxis->setLabel(tr("Amplitude, %1").arg(unit));
    for (QCustomPlot *plot : {m_wave, m_lines}) {
        plot->setPlottingHints(QCP::PlottingHints(QCP::phFastPolylines) | QCP::phCacheLabels);
        plot->legend->setVisible(true);
        for (const Quantity quantity : {Quantity::SampleX, Quantity::SampleY}) {
            plot->addGraph()->setName(plottext::quantity(quantity));
        }
        plot->installEventFilter(this);
    }
    dress();
}

/// In the colours of the desktop, which may change while the program runs.
void WaveformPage::dress()
{
    for (QCustomPlot *plot : {m_wave, m_lines}) {
        for (int axis = 0; axis < plot->graphCount(); ++axis) {
            const CurveStyle style = curveStyle(axis, colours::isDark(palette()));
            plot->graph(axis)->setPen(QPen(style.colour, 1, style.line));
        }
        plotlook::dress(*plot);
        plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

/// Of the plots: they get a palette after their page.
bool WaveformPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        dress();
        takeAnalysis(); // the labels have the colours of their curves
    }
    return SpanPage::eventFilter(watched, event);
}

void WaveformPage::buildChoices()
{
    auto *windows = new QComboBox(bar());
    windows->setObjectName(QStringLiteral("spectrumWindow"));
    windows->setToolTip(tr("Window of the spectrum"));
    windows->addItem(tr("Hann"), int(SpectrumWindow::Hann));
    windows->addItem(tr("Hamming"), int(SpectrumWindow::Hamming));
    windows->addItem(tr("Blackman-Harris"), int(SpectrumWindow::BlackmanHarris));
    windows->addItem(tr("no window"), int(SpectrumWindow::Rectangular));
    auto *lengths = new QComboBox(bar());
    lengths->setObjectName(QStringLiteral("spectrumLength"));
    lengths->setToolTip(
        tr("Samples of a segment: more give finer lines, fewer are averaged oftener and calm the noise"));
    for (const int length : {128, 256, 512, 1024, 2048, 4096, 8192, 16384}) {
        lengths->addItem(tr("%1 samples").arg(length), length);
    }
    lengths->setCurrentIndex(lengths->findData(1024));
    m_settings.length = 1024;
    bar()->addSeparator();
    bar()->addWidget(windows);
    bar()->addWidget(lengths);
    connect(windows, &QComboBox::currentIndexChanged, this, [this, windows] {
        m_settings.window = static_cast<SpectrumWindow>(windows->currentData().toInt());
        analyse();
    });
    connect(lengths, &QComboBox::currentIndexChanged, this, [this, lengths] {
        m_settings.length = lengths->currentData().toInt();
        analyse();
    });
}

void WaveformPage::drawSamples(QCPGraph *graph, const Series &series)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    QVector<QCPGraphData> points;
    points.reserve(series.buckets.size());
    auto gap = series.gaps.cbegin();
    for (const SeriesBucket &bucket : series.buckets) {
        for (; gap != series.gaps.cend() && gap->from <= bucket.from; ++gap) {
            points.append({toKey(gap->from), nothing});
        }
        points.append({toKey(bucket.from), bucket.valid > 0 ? bucket.mean : nothing});
    }
    graph->data()->set(points, true);
}

/// Of a span that moves on with the clock only the length counts: its samples come with the next answer.
bool WaveformPage::isOtherSpan() const
{
    const TimeSpan seen = span();
    return isFollowing() ? seen.to - seen.from != m_analysed.to - m_analysed.from : seen != m_analysed;
}

void WaveformPage::draw()
{
    m_wave->xAxis->setRange(toKey(span().from), toKey(span().to));
    const Series x = first();
    const Series y = second();
    const bool isOther = x != m_x || y != m_y;
    if (isOther) {
        m_x = x;
        m_y = y;
        drawSamples(m_wave->graph(0), m_x);
        drawSamples(m_wave->graph(1), m_y);
    }
    if (isOther || isOtherSpan()) {
        fitSamples();
        analyse();
    }
    m_wave->replot(QCustomPlot::rpQueuedReplot);
    setNote(m_note);
}

/// To what is seen: the answer reaches beyond it.
void WaveformPage::fitSamples()
{
    std::optional<QCPRange> seen;
    for (const QCPGraph *graph : {m_wave->graph(0), m_wave->graph(1)}) {
        bool isFound = false;
        const QCPRange range = graph->getValueRange(isFound, QCP::sdBoth, m_wave->xAxis->range());
        if (isFound) {
            seen = seen ? seen->expanded(range) : range;
        }
    }
    if (seen) {
        const double size = std::max(seen->size(), leastScale) * (1 + 2 * airOfScale);
        m_wave->yAxis->setRange(seen->center() - size / 2, seen->center() + size / 2);
    }
}

void WaveformPage::analyse()
{
    m_analysed = span();
    m_analysis.cancel();
    m_analysis.setFuture(analysed(m_x, m_y, m_analysed, m_settings));
}

void WaveformPage::takeAnalysis()
{
    if (m_analysis.isFinished() && !m_analysis.isCanceled() && m_analysis.future().resultCount() > 0) {
        const WaveformAnalyses result = m_analysis.result();
        showAnalysis(result.first, result.second);
    }
}

void WaveformPage::drawSpectrum(QCPGraph *graph, const Spectrum &spectrum)
{
    QVector<QCPGraphData> points;
    for (qsizetype line = 1; line < spectrum.amplitude.size(); ++line) {
        points.append({static_cast<double>(line) * spectrum.resolution, spectrum.amplitude.at(line)});
    }
    graph->data()->set(points, true);
}

void WaveformPage::showAnalysis(const WaveformAnalysis &x, const WaveformAnalysis &y)
{
    m_lines->clearItems();
    drawSpectrum(m_lines->graph(0), x.spectrum);
    drawSpectrum(m_lines->graph(1), y.spectrum);
    QStringList found;
    double highest = 0; // a peak may lie between two lines, above both
    for (int axis = 0; axis < 2; ++axis) {
        QStringList frequencies;
        for (const SpectrumPeak &peak : (axis == 0 ? x : y).peaks) {
            auto *label = new QCPItemText(m_lines);
            label->position->setCoords(peak.frequency, peak.amplitude);
            highest = std::max(highest, peak.amplitude);
            label->setPositionAlignment(Qt::AlignBottom | Qt::AlignHCenter);
            label->setText(QString::number(peak.frequency, 'f', 3));
            label->setColor(m_lines->graph(axis)->pen().color());
            frequencies +=
                tr("%1 Hz (%2)").arg(QString::number(peak.frequency, 'f', 3), QString::number(peak.amplitude, 'f', 2));
        }
        if (!frequencies.isEmpty()) {
            found += QStringLiteral("%1: %2").arg(m_lines->graph(axis)->name(), frequencies.join(QStringLiteral(", ")));
        }
    }
    m_lines->rescaleAxes();
    m_lines->xAxis->setRangeLower(0);
    m_lines->yAxis->setRangeLower(0);
    m_lines->yAxis->setRangeUpper(std::max(m_lines->yAxis->range().upper, highest) * 1.15);
    m_lines->replot(QCustomPlot::rpQueuedReplot);
    m_note = x.spectrum.segments == 0
        ? tr("Too few samples for a spectrum.")
        : tr("Segments averaged: %1, a line every %2 Hz. %3")
              .arg(
                  QString::number(x.spectrum.segments), QString::number(x.spectrum.resolution, 'f', 4),
                  found.isEmpty() ? tr("No frequency stands out.") : found.join(QStringLiteral("; ")));
    setNote(m_note);
}

} // namespace gorizont
