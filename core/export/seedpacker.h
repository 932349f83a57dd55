#pragma once

#include "core/export/seedcodes.h"
#include "core/values/sampleblock.h"

#include <QByteArray>

#include <memory>

struct MSRecord_s;

namespace gorizont {

/// Makes the miniSEED records of one axis of an accelerometer out of its blocks: Steim-2, 4096 bytes, big-endian, raw
/// units of the device. Whatever does not follow begins a record of its own, so that every reader sees the gap. Keeps no
/// more than the samples of the record that is being filled.
class SeedPacker
{
public:
    enum class Axis : quint8 { X, Y };

    /// \a codes are valid, \a location is a seedLocation().
    SeedPacker(const SeedCodes &codes, const QString &location, Axis axis);
    ~SeedPacker();
    Q_DISABLE_COPY_MOVE(SeedPacker)

    /// The records that are full with the samples of \a block from the sample \a first on, \a count of them.
    QByteArray add(const SampleBlock &block, qsizetype first, qsizetype count);

    /// The record of the samples that are left; what is added next begins a new one.
    QByteArray flush();

private:
    QByteArray pack(bool isEnd);

    std::unique_ptr<MSRecord_s, void (*)(MSRecord_s *)> m_record;
    const Axis m_axis;
    UtcTime m_start; ///< of the first sample in m_samples
    double m_rate = 0; ///< samples a second; 0: nothing has been added
    QList<qint32> m_samples; ///< not packed yet
};

} // namespace gorizont
