#pragma once

#include "ui/vibration/vibrationanalysis.h"
#include "ui/vibration/vibrationcapture.h"

#include <QFutureWatcher>
#include <QWidget>

#include <map>

class QLabel;

namespace gorizont {

class CursorLines;
class ScopePlot;
class SpectrumPlot;

/// The waveform above, below it both spectra of the module over that of the waveform; cursors in each, and what they read. GUI
/// thread.
class VibrationPlots : public QWidget
{
    Q_OBJECT

public:
    /// How signals are drawn.
    struct View
    {
        lvims::CodeUnit unit = lvims::CodeUnit::Physical;
        QString unitName; ///< `mm/s²`, `V`
        bool isDensity = false; ///< of the spectra
    };

    explicit VibrationPlots(QWidget *parent = nullptr);

    void setView(const View &view);
    /// Takes the place of the one of its kind.
    void show(const CapturedSignal &signal);
    void clear();
    /// nullptr: there is none.
    const CapturedSignal *signal(lvims::Capture::Kind kind) const;

    void setCursorsShown(bool isShown);
    void showWhole();

protected:
    void changeEvent(QEvent *event) override;

private:
    SpectrumPlot *makeSpectrum(const QString &name, double highest, const char *objectName, const QString &title);
    CursorLines *addCursors(ScopePlot *plot);
    void drawWaveform();
    void analyse();
    void drawSpectra();
    void dress();
    void read();
    QString readWaveform() const;
    QString readSpectrum(const SpectrumPlot &plot, const CursorLines &cursors, const QString &name) const;
    VibrationSpectrum module(lvims::Capture::Kind kind) const;

    ScopePlot *m_wave;
    SpectrumPlot *m_to5000;
    SpectrumPlot *m_to200;
    QList<CursorLines *> m_cursors; ///< of the three
    QLabel *m_readings; ///< at the cursors
    QLabel *m_peaks;
    View m_view;
    std::map<lvims::Capture::Kind, CapturedSignal> m_signals;
    VibrationSpectrum m_own;
    QFutureWatcher<VibrationSpectrum> m_analysis; ///< the last that was begun; it ends with the plots
};

} // namespace gorizont
