#include "core/analysis/spectrum.h"

#include <QMutex>

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace gorizont {

namespace {

constexpr qsizetype shortestSegment = 8;

/// FFTW lets one thread at a time make or destroy plans; to execute them needs no lock.
QMutex &planMutex()
{
    static QMutex mutex;
    return mutex;
}

/// The transform of real segments of one length, with its buffers.
class Transform
{
public:
    explicit Transform(qsizetype length)
        : m_in(fftw_alloc_real(static_cast<std::size_t>(length)))
        , m_out(fftw_alloc_complex(static_cast<std::size_t>(length / 2 + 1)))
    {
        const QMutexLocker lock(&planMutex());
        m_plan = fftw_plan_dft_r2c_1d(static_cast<int>(length), m_in.get(), m_out.get(), FFTW_ESTIMATE);
    }
    ~Transform()
    {
        const QMutexLocker lock(&planMutex());
        fftw_destroy_plan(m_plan);
    }
    Q_DISABLE_COPY_MOVE(Transform)

    double *input() { return m_in.get(); }
    void execute() { fftw_execute(m_plan); }
    double power(qsizetype line) const
    {
        const fftw_complex &value = m_out.get()[line];
        return value[0] * value[0] + value[1] * value[1];
    }

private:
    struct Free
    {
        void operator()(void *memory) const { fftw_free(memory); }
    };
    std::unique_ptr<double[], Free> m_in;
    std::unique_ptr<fftw_complex[], Free> m_out;
    fftw_plan m_plan = nullptr;
};

qsizetype longest(const QList<QList<double>> &stretches)
{
    qsizetype length = 0;
    for (const QList<double> &stretch : stretches) {
        length = std::max(length, stretch.size());
    }
    return length;
}

void load(Transform &transform, const QList<double> &samples, qsizetype from, const QList<double> &weights)
{
    const auto first = samples.cbegin() + from;
    const double mean = std::accumulate(first, first + weights.size(), 0.0) / static_cast<double>(weights.size());
    for (qsizetype n = 0; n < weights.size(); ++n) {
        transform.input()[n] = (*(first + n) - mean) * weights.at(n);
    }
}

/// Sums of powers become means of powers, and those the two scales.
void scale(Spectrum &result, QList<double> powers, double rate, const QList<double> &weights)
{
    const double sum = std::accumulate(weights.cbegin(), weights.cend(), 0.0);
    const double squares = std::inner_product(weights.cbegin(), weights.cend(), weights.cbegin(), 0.0);
    for (qsizetype line = 0; line < powers.size(); ++line) {
        const bool isAlone = line == 0 || line * 2 == weights.size(); // no mirror image at negative frequencies
        const double power = powers.at(line) / static_cast<double>(result.segments);
        result.amplitude.append((isAlone ? 1 : 2) * std::sqrt(power) / sum);
        result.density.append((isAlone ? 1 : 2) * power / (rate * squares));
    }
}

} // namespace

Spectrum spectrum(const QList<QList<double>> &stretches, double rate, const SpectrumSettings &settings)
{
    const qsizetype length = std::min(std::max(settings.length, shortestSegment), longest(stretches));
    if (length < shortestSegment || !(rate > 0) || !std::isfinite(rate)) {
        return {};
    }
    Spectrum result;
    result.window = settings.window;
    result.length = length;
    result.resolution = rate / static_cast<double>(length);
    const QList<double> weights = windowWeights(settings.window, length);
    const double overlap = std::clamp(settings.overlap, 0.0, 0.99);
    const auto step = std::max<qsizetype>(1, std::llround(static_cast<double>(length) * (1 - overlap)));
    QList<double> powers(length / 2 + 1, 0.0);
    Transform transform(length);
    for (const QList<double> &stretch : stretches) {
        for (qsizetype from = 0; from + length <= stretch.size(); from += step) {
            load(transform, stretch, from, weights);
            transform.execute();
            for (qsizetype line = 0; line < powers.size(); ++line) {
                powers[line] += transform.power(line);
            }
            ++result.segments;
        }
    }
    scale(result, powers, rate, weights);
    return result;
}

} // namespace gorizont
