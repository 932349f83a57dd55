#pragma once

#include "core/registry/sensorregistry.h"

#include <QObject>

#include <atomic>

namespace gorizont {

/// `--print-readings`: each answer of a sensor, and each change of a status word, as one JSON line on stdout. Lives in a
/// thread of its own, so that a reader that stops reading holds up nobody; what it misses then is counted, not kept.
class ReadingPrinter : public QObject
{
    Q_OBJECT

public:
    explicit ReadingPrinter(const SensorRegistry &registry);

    /// Called in the main thread by the registry; copies the batch over unless too much is waiting.
    void offer(const Readings &batch);

private:
    struct Known
    {
        SensorConfig config;
        LineConfig line;
        quint16 status = 0;
    };

    void print(const Readings &batch);

    static constexpr int longestQueue = 1000; ///< batches
    QHash<int, Known> m_known; ///< by site number; used in the printer's thread only
    std::atomic_int m_waiting{0};
    std::atomic_bool m_isClosed{false}; ///< nobody reads stdout any more
};

} // namespace gorizont
