#pragma once

#include "ui/plots/spanpage.h"
#include "ui/plots/waveformanalysis.h"

#include <QFutureWatcher>

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
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildPlots();
    void dress();
    void buildChoices();
    void drawSamples(QCPGraph *graph, const Series &series);
    bool isOtherSpan() const;
    void fitSamples();
    void analyse();
    void takeAnalysis();
    void showAnalysis(const WaveformAnalysis &x, const WaveformAnalysis &y);
    void drawSpectrum(QCPGraph *graph, const Spectrum &spectrum);

    QWidget *m_content;
    QCustomPlot *m_wave;
    QCustomPlot *m_lines; ///< of the spectrum
    Series m_x; ///< as drawn and analysed last
    Series m_y;
    TimeSpan m_analysed; ///< the span that was seen when they were
    SpectrumSettings m_settings;
    QFutureWatcher<WaveformAnalyses> m_analysis; ///< the last that was begun; it ends with the page
    QString m_note;
};

} // namespace gorizont
