#include "core/analysis/spectrumpeaks.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

using namespace gorizont;

namespace {

constexpr double rate = 10;

QList<double> sine(double frequency, double amplitude, qsizetype length, double mean = 0)
{
    QList<double> samples;
    for (qsizetype n = 0; n < length; ++n) {
        samples.append(
            mean + amplitude * std::sin(2 * std::numbers::pi * frequency * static_cast<double>(n) / rate + 0.4));
    }
    return samples;
}

QList<double> noise(qsizetype length, double deviation)
{
    std::mt19937 generator(4711);
    std::normal_distribution<double> normal(0, deviation);
    QList<double> samples;
    for (qsizetype n = 0; n < length; ++n) {
        samples.append(normal(generator));
    }
    return samples;
}

double variance(const QList<double> &samples)
{
    const auto count = static_cast<double>(samples.size());
    const double mean = std::accumulate(samples.cbegin(), samples.cend(), 0.0) / count;
    return std::accumulate(
               samples.cbegin(), samples.cend(), 0.0,
               [mean](double sum, double value) { return sum + (value - mean) * (value - mean); })
        / count;
}

double power(const Spectrum &result)
{
    return std::accumulate(result.density.cbegin(), result.density.cend(), 0.0) * result.resolution;
}

/// A difference of \a share of the larger one.
bool isNear(double a, double b, double share)
{
    return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b)) + 1e-9;
}

} // namespace

/// Spectra against numpy and against what sines and noise must give.
class TestSpectrum : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// numpy 1.24, segments of 16 samples of x[n] = ((7n² + 3n) mod 31) − 15 + n/4, n < 64, that overlap by half, each
    /// without its mean: rfft(segment × window), powers averaged, amplitude f·√P/Σw and density f·P/(10 Hz · Σw²) with
    /// f = 1 at both ends, else 2.
    void likeNumpy_data()
    {
        QTest::addColumn<SpectrumWindow>("window");
        QTest::addColumn<QList<double>>("amplitude");
        QTest::addColumn<QList<double>>("density");
        QTest::newRow("rectangular")
            << SpectrumWindow::Rectangular
            << QList<
                   double>{0, 4.00090379604, 3.18130858303, 6.31995158101, 4.92941245412, 3.11455258862, 2.50263946084, 2.98098260427, 0.934220454252}
            << QList<double>{
                   0,
                   12.8057849481,
                   8.09657944037,
                   31.9534303891,
                   19.4392857143,
                   7.76035026184,
                   5.01056341677,
                   7.10900582956,
                   1.39642857143};
        QTest::newRow("Hann") << SpectrumWindow::Hann << QList<double>{1.42949566974, 3.56630528522, 4.23958507114,
                                                                       6.80492976684, 6.25377399299, 4.60508401949,
                                                                       3.09038867353, 3.16586616787, 1.53824172888}
                              << QList<double>{2.17968839445, 6.7832178066,  9.58617684024,
                                               24.6971035369, 20.8585008829, 11.3102927075,
                                               5.09360114853, 5.34544458285, 2.52393345758};
        QTest::newRow("Hamming") << SpectrumWindow::Hamming
                                 << QList<double>{1.21771853348, 3.58976856219, 3.85734610244,
                                                  6.64815948963, 5.94518557765, 4.31228797127,
                                                  2.88474350625, 3.0868910506,  1.44015713043}
                                 << QList<double>{1.74089858178, 7.56454034637, 8.73427496124,
                                                  25.9449299914, 20.7482023569, 10.9160408913,
                                                  4.88499420279, 5.59361082652, 2.43500242212};
        QTest::newRow("Blackman-Harris") << SpectrumWindow::BlackmanHarris
                                         << QList<double>{1.93938925264, 4.08407299694, 5.28516804369,
                                                          7.30915817228, 7.10707624398, 5.46505011458,
                                                          3.98342258204, 3.54019053836, 1.76378783982}
                                         << QList<double>{3.00244979935, 6.65737133469, 11.148935187,
                                                          21.3231081887, 20.1603347493, 11.9207639275,
                                                          6.33327800293, 5.00229228453, 2.48335309382};
    }
    void likeNumpy()
    {
        QFETCH(SpectrumWindow, window);
        QFETCH(QList<double>, amplitude);
        QFETCH(QList<double>, density);
        QList<double> samples;
        for (int n = 0; n < 64; ++n) {
            samples.append((7 * n * n + 3 * n) % 31 - 15 + 0.25 * n);
        }
        const Spectrum result = spectrum({samples}, rate, {window, 16, 0.5});
        QCOMPARE(result.segments, 7);
        QCOMPARE(result.length, 16);
        QCOMPARE(result.resolution, 0.625);
        QCOMPARE(result.amplitude.size(), amplitude.size());
        for (qsizetype line = 0; line < amplitude.size(); ++line) {
            QVERIFY2(isNear(result.amplitude.at(line), amplitude.at(line), 1e-9), qPrintable(QString::number(line)));
            QVERIFY2(isNear(result.density.at(line), density.at(line), 1e-9), qPrintable(QString::number(line)));
        }
    }

    void allWindows_data()
    {
        QTest::addColumn<SpectrumWindow>("window");
        QTest::newRow("rectangular") << SpectrumWindow::Rectangular;
        QTest::newRow("Hann") << SpectrumWindow::Hann;
        QTest::newRow("Hamming") << SpectrumWindow::Hamming;
        QTest::newRow("Blackman-Harris") << SpectrumWindow::BlackmanHarris;
        QTest::newRow("Blackman") << SpectrumWindow::Blackman;
    }

    void sineOnALine_data() { allWindows_data(); }
    void sineOnALine()
    {
        QFETCH(SpectrumWindow, window);
        const Spectrum result = spectrum({sine(1.25, 3.5, 4096, -700)}, rate, {window, 1024, 0.5});
        QVERIFY(isNear(result.amplitude.at(128), 3.5, 1e-6)); // 1.25 Hz ÷ (10 Hz ÷ 1024)
        const QList<SpectrumPeak> found = peaks(result, 5);
        QCOMPARE(found.size(), 1);
        QVERIFY(isNear(found.first().frequency, 1.25, 1e-6));
        QVERIFY(isNear(found.first().amplitude, 3.5, 1e-6));
    }

    void sineBetweenLines_data() { allWindows_data(); }
    void sineBetweenLines()
    {
        QFETCH(SpectrumWindow, window);
        // Without a window a line leaks its mirror image everywhere, so that its place is known less well.
        const double share = window == SpectrumWindow::Rectangular ? 2e-2 : 2e-3;
        for (const double offset : {-0.45, -0.2, 0.1, 0.3, 0.5}) {
            const double frequency = (200 + offset) * rate / 1024;
            const Spectrum result = spectrum({sine(frequency, 2, 20000)}, rate, {window, 1024, 0.5});
            const SpectrumPeak peak = peaks(result, 1).value(0);
            QVERIFY2(
                std::abs(peak.frequency - frequency) < 10 * share * result.resolution,
                qPrintable(QString::number((peak.frequency - frequency) / result.resolution)));
            QVERIFY2(isNear(peak.amplitude, 2, 2 * share), qPrintable(QString::number(peak.amplitude)));
        }
    }

    void twoSinesInNoise()
    {
        QList<double> samples = noise(32768, 0.5);
        const QList<double> strong = sine(0.213, 4, samples.size());
        const QList<double> weak = sine(2.71, 0.6, samples.size());
        for (qsizetype n = 0; n < samples.size(); ++n) {
            samples[n] += strong.at(n) + weak.at(n);
        }
        const QList<SpectrumPeak> found = peaks(spectrum({samples}, rate, {SpectrumWindow::Hann, 4096, 0.5}), 4);
        QCOMPARE(found.size(), 2);
        QVERIFY(isNear(found.at(0).frequency, 0.213, 1e-3));
        QVERIFY(isNear(found.at(0).amplitude, 4, 0.01));
        QVERIFY(isNear(found.at(1).frequency, 2.71, 1e-3));
        QVERIFY(isNear(found.at(1).amplitude, 0.6, 0.1));
    }

    /// Parseval: exactly without a window and overlap, for every length of a segment, odd ones included.
    void parseval_data()
    {
        QTest::addColumn<int>("length");
        QTest::newRow("even") << 960;
        QTest::newRow("odd") << 961;
        QTest::newRow("short") << 8;
    }
    void parseval()
    {
        QFETCH(int, length);
        const QList<double> samples = noise(length, 7);
        const Spectrum result = spectrum({samples}, rate, {SpectrumWindow::Rectangular, length, 0});
        QVERIFY(isNear(power(result), variance(samples), 1e-12));
    }

    /// White noise of deviation σ has the density 2σ²/rate at every frequency, whatever the window.
    void whiteNoise_data() { allWindows_data(); }
    void whiteNoise()
    {
        QFETCH(SpectrumWindow, window);
        const Spectrum result = spectrum({noise(400000, 3)}, rate, {window, 512, 0.5});
        QVERIFY(isNear(power(result), 9, 0.01));
        for (qsizetype line = 8; line + 1 < result.density.size(); ++line) {
            QVERIFY(isNear(result.density.at(line), 2 * 9 / rate, 0.25));
        }
        QCOMPARE(peaks(result, 5).size(), 0);
    }

    /// Harris, "On the use of windows", 1978, table 1: coherent gain, equivalent noise bandwidth, scallop loss.
    void windowFigures_data()
    {
        QTest::addColumn<SpectrumWindow>("window");
        QTest::addColumn<double>("gain");
        QTest::addColumn<double>("bandwidth");
        QTest::addColumn<double>("scallop");
        QTest::newRow("rectangular") << SpectrumWindow::Rectangular << 1.00 << 1.00 << 3.92;
        QTest::newRow("Hann") << SpectrumWindow::Hann << 0.50 << 1.50 << 1.42;
        QTest::newRow("Hamming") << SpectrumWindow::Hamming << 0.54 << 1.36 << 1.78;
        QTest::newRow("Blackman-Harris") << SpectrumWindow::BlackmanHarris << 0.36 << 2.00 << 0.83;
        QTest::newRow("Blackman") << SpectrumWindow::Blackman << 0.42 << 1.73 << 1.10;
    }
    void windowFigures()
    {
        QFETCH(SpectrumWindow, window);
        QFETCH(double, gain);
        QFETCH(double, bandwidth);
        QFETCH(double, scallop);
        const QList<double> weights = windowWeights(window, 1000);
        const double sum = std::accumulate(weights.cbegin(), weights.cend(), 0.0);
        const double squares = std::inner_product(weights.cbegin(), weights.cend(), weights.cbegin(), 0.0);
        QVERIFY(std::abs(sum / 1000 - gain) < 0.005);
        QVERIFY(std::abs(1000 * squares / (sum * sum) - bandwidth) < 0.01);
        QVERIFY(std::abs(-20 * std::log10(windowResponse(window, 0.5)) - scallop) < 0.03);
        QCOMPARE(windowResponse(window, 0), 1.0);
    }

    /// Two stretches are two sets of segments: a jump between them is in no segment.
    void stretchesAreNotJoined()
    {
        const QList<double> low = sine(1.25, 1, 1024, -500);
        const QList<double> high = sine(1.25, 1, 1024, 500);
        const SpectrumSettings settings{SpectrumWindow::Hann, 256, 0.5};
        const Spectrum apart = spectrum({low, high}, rate, settings);
        QCOMPARE(apart.segments, 14);
        QVERIFY(isNear(power(apart), 0.5, 1e-6));
        QVERIFY(power(spectrum({low + high}, rate, settings)) > 1000);
    }

    void whatIsTooShort()
    {
        QCOMPARE(spectrum({}, rate, {}).segments, 0);
        QCOMPARE(spectrum({sine(1, 1, 7)}, rate, {}).segments, 0);
        QCOMPARE(spectrum({sine(1, 1, 100)}, 0, {}).segments, 0);
        QCOMPARE(spectrum({sine(1, 1, 100)}, std::nan(""), {}).segments, 0);
        const Spectrum shorter = spectrum({sine(1, 1, 60), sine(1, 1, 100)}, rate, {});
        QCOMPARE(shorter.length, 100);
        QCOMPARE(shorter.segments, 1);
        QVERIFY(peaks(Spectrum(), 5).isEmpty());
    }

    void silenceHasNoPeaks()
    {
        const Spectrum result = spectrum({QList<double>(1024, 5.0)}, rate, {});
        QCOMPARE(*std::max_element(result.amplitude.cbegin(), result.amplitude.cend()), 0.0);
        QVERIFY(peaks(result, 5).isEmpty());
    }
};

QTEST_APPLESS_MAIN(TestSpectrum)
#include "tst_spectrum.moc"
