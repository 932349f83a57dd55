#pragma once

#include "ui/vibration/scopeplot.h"
#include "ui/vibration/vibrationanalysis.h"

namespace gorizont {

/// A spectrum of the module over that of its waveform, with the highest peaks of the one in front. GUI thread.
class SpectrumPlot : public ScopePlot
{
    Q_OBJECT

public:
    /// \a highest: Hz, the end of what is shown.
    SpectrumPlot(const QString &moduleName, double highest, QWidget *parent = nullptr);

    /// Both in \a unit; density instead of amplitude if \a isDensity.
    void showSpectra(
        const VibrationSpectrum &module, const VibrationSpectrum &own, const QString &unit, bool isDensity);

    /// What stands at \a frequency, `120.1 | 119.8`: module and own; `—` where there is nothing.
    QString valuesAt(double frequency) const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void dressCurves();
    void drawPeaks();
    void placeLabels();
    QList<double> heights(const Spectrum &spectrum) const
    {
        return m_isDensity ? spectrum.density : spectrum.amplitude;
    }
    void draw(int curve, const Spectrum &spectrum);
    QString valueAt(const Spectrum &spectrum, double frequency) const;

    const double m_highest;
    VibrationSpectrum m_module;
    VibrationSpectrum m_own;
    QList<QCPItemText *> m_labels; ///< of the peaks
    bool m_isDensity = false;
};

} // namespace gorizont
