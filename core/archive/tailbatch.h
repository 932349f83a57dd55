#pragma once

#include "core/archive/keptreading.h"
#include "core/values/sampleblock.h"

#include <QByteArray>
#include <QSet>

#include <optional>

namespace gorizont {

/// What came within one commit and is not in a chunk yet; the rows that are read again after a kill. Made to be written
/// fast: values stand as they are. Pure.
///
///     version 1 · items · CRC-32; an item is a kind (1 reading, 2 block of samples), a number N and a piece:
///     1   time (signed µs UTC) · for each quantity of the sensor: byte quantity, byte valid, and if valid a double
///     2   start (signed µs UTC) · byte follows the previous · rate · scale (doubles) · count · x · y (signed numbers)
class TailBatch
{
public:
    struct Contents
    {
        QList<KeptReading> readings; ///< in the order of arrival
        QList<SampleBlock> blocks;
        bool operator==(const Contents &) const = default;
    };

    void add(const KeptReading &reading);
    void add(const SampleBlock &block);
    bool isEmpty() const { return m_items.isEmpty(); }
    QByteArray take();

    /// What sensors that are not among \a only sent is left out; an empty set: nothing is. Empty: \a bytes are damaged.
    static std::optional<Contents> decode(QByteArrayView bytes, const QSet<int> &only = {});

private:
    QByteArray m_items;
};

} // namespace gorizont
