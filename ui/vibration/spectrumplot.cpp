#include "ui/vibration/spectrumplot.h"

#include "ui/models/colours.h"
#include "ui/models/valuetext.h"
#include "ui/plots/curvestyle.h"
#include "ui/vibration/capturetext.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr int moduleCurve = 0;
constexpr int ownCurve = 1;

} // namespace

SpectrumPlot::SpectrumPlot(const QString &moduleName, double highest, QWidget *parent)
    : ScopePlot(parent)
    , m_highest(highest)
{
    addGraph()->setName(moduleName);
    addGraph()->setName(tr("of the waveform"));
    legend->setVisible(true);
    xAxis->setLabel(tr("Frequency, Hz"));
    setFromZero(true);
    setWhole({0, highest});
    dressCurves();
    connect(this, &QCustomPlot::beforeReplot, this, &SpectrumPlot::placeLabels);
}

/// The module's own in front.
void SpectrumPlot::dressCurves()
{
    for (int i = 0; i < graphCount(); ++i) {
        const CurveStyle style = curveStyle(i, colours::isDark(palette()));
        graph(i)->setPen(QPen(style.colour, 1, style.line));
    }
    for (QCPItemText *label : m_labels) {
        label->setColor(palette().color(QPalette::Text));
        label->setFont(font());
    }
}

void SpectrumPlot::changeEvent(QEvent *event)
{
    ScopePlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        dressCurves();
    }
}

void SpectrumPlot::showSpectra(
    const VibrationSpectrum &module, const VibrationSpectrum &own, const QString &unit, bool isDensity)
{
    m_module = module;
    m_own = own;
    m_isDensity = isDensity;
    yAxis->setLabel(isDensity ? tr("Density, (%1)²/Hz").arg(unit) : tr("Amplitude, %1").arg(unit));
    draw(moduleCurve, module.lines);
    draw(ownCurve, own.lines);
    drawPeaks();
    fit();
}

/// Without the constant part, which would hide everything else.
void SpectrumPlot::draw(int curve, const Spectrum &spectrum)
{
    const QList<double> values = heights(spectrum);
    QVector<QCPGraphData> points;
    for (qsizetype line = 1; line < values.size(); ++line) {
        const double frequency = static_cast<double>(line) * spectrum.resolution;
        if (frequency > m_highest) {
            break;
        }
        points.append({frequency, values.at(line)});
    }
    graph(curve)->data()->set(points, true);
}

/// Those of the module; without it, those of the waveform.
void SpectrumPlot::drawPeaks()
{
    for (QCPItemText *label : std::exchange(m_labels, {})) {
        removeItem(label);
    }
    const VibrationSpectrum &marked = m_module.lines.amplitude.isEmpty() ? m_own : m_module;
    const QList<double> values = heights(marked.lines);
    for (const SpectrumPeak &peak : marked.peaks) {
        const qsizetype line = qRound64(peak.frequency / marked.lines.resolution);
        if (peak.frequency > m_highest || line >= values.size()) {
            continue;
        }
        auto *label = new QCPItemText(this);
        label->position->setCoords(peak.frequency, values.at(line));
        label->setPositionAlignment(Qt::AlignBottom | Qt::AlignHCenter);
        label->setText(QString::number(peak.frequency, 'f', 2));
        m_labels.append(label);
    }
    dressCurves();
}

/// A label that would cover that of a higher peak is left out; zooming makes room.
void SpectrumPlot::placeLabels()
{
    const int room = 2 * fontMetrics().horizontalAdvance(QStringLiteral("0000.00")) / 3;
    QList<double> taken;
    for (QCPItemText *label : m_labels) {
        const double pixel = xAxis->coordToPixel(label->position->key());
        const bool isFree = std::none_of(taken.cbegin(), taken.cend(), [=](double other) {
            return std::abs(other - pixel) < 2 * room;
        });
        const bool isAtEdge = pixel - axisRect()->left() < room;
        label->setVisible(isFree);
        label->setPositionAlignment(Qt::AlignBottom | (isAtEdge ? Qt::AlignLeft : Qt::AlignHCenter));
        if (isFree) {
            taken.append(pixel);
        }
    }
}

QString SpectrumPlot::valueAt(const Spectrum &spectrum, double frequency) const
{
    const QList<double> values = heights(spectrum);
    const qsizetype line = spectrum.resolution > 0 ? qRound64(frequency / spectrum.resolution) : -1;
    return line >= 0 && line < values.size() ? capturetext::number(values.at(line)) : valuetext::absent();
}

QString SpectrumPlot::valuesAt(double frequency) const
{
    return QStringLiteral("%1 | %2").arg(valueAt(m_module.lines, frequency), valueAt(m_own.lines, frequency));
}

} // namespace gorizont
