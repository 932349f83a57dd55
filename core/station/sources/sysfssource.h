#pragma once

#include "core/station/sources/source.h"
#include "core/station/sources/sourcefile.h"

namespace gorizont::station {

/// Linux IIO and other files that hold one number: `in_voltageM_raw`, with `in_voltageM_scale` and `in_voltageM_offset` or those
/// that all inputs of the device share; V = (raw + offset) · scale / 1000, as the kernel's ABI of iio says (mV). A digital
/// input is on unless its file holds 0; a file of pulses holds a count that grows.
class SysfsSource : public Source
{
public:
    explicit SysfsSource(const SourcePlan &plan);

    QString name() const override;
    double rate() const override { return m_rate; }
    QString open() override;
    QString measure(const SampleMoment &moment, RawSample &sample) override;

private:
    struct Input
    {
        FileChannel file;
        QString path; ///< of the file that is read again and again
        double scale = 1; ///< to V
        double offset = 0; ///< of the raw number
        std::optional<double> lastCount;
        std::chrono::duration<double> lastTime{0};
    };

    QString openIio(Input &input) const;
    void countPulses(Input &input, double count, const SampleMoment &moment, RawSample &sample) const;

    QList<FileChannel> m_files;
    double m_rate;
    QList<Input> m_inputs;
};

} // namespace gorizont::station
