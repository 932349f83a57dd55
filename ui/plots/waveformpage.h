#pragma once

#include "core/analysis/samplestretches.h"
#include "core/analysis/spectrumpeaks.h"
#include "ui/plots/spanpage.h"

class QCPGraph;
class QCustomPlot;

namespace gorizont {

/// The page <Колебания>: the samples of an accelerometer, the spectrum of both axes and its strongest frequencies. GUI
/// thread.
class WaveformPage : public SpanPage
{
    Q_OBJECT

public:
    WaveformPage(
        SensorRegistry &registry, SeriesSource source, QWidget *parent = nullptr, SeriesFeed::Clock clock = utcNow);

protected:
    void draw() override;

private:
    void buildPlots();
    void buildChoices();
    void drawSamples(QCPGraph *graph, const Series &series);
    void analyse();
    void showAnalysis(const WaveformAnalysis &x, const WaveformAnalysis &y);
    void drawSpectrum(QCPGraph *graph, const Spectrum &spectrum);

    QWidget *m_content;
    QCustomPlot *m_wave;
    QCustomPlot *m_lines; ///< of the spectrum
    Series m_x; ///< as drawn and analysed last
    Series m_y;
    SpectrumSettings m_settings;
    int m_question = 0; ///< only the last analysis counts
    QString m_note;
};

} // namespace gorizont
