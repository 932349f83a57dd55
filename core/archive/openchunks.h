#pragma once

#include "core/archive/readingchunk.h"
#include "core/archive/samplechunk.h"
#include "core/values/series.h"

#include <map>

namespace gorizont {

/// What is in the tail and not in a chunk yet, one entry a sensor. Pure.
class OpenChunks
{
public:
    static constexpr std::size_t ripeReadings = 512;
    static constexpr std::size_t ripeSamples = 8192;
    static constexpr qint64 ripeCommits = 3600; ///< so that a sensor that is silent does not keep the tail long
    static constexpr std::chrono::hours longest{1}; ///< from the first to the last time of a chunk

    /// Chunks that follow each other, and the rows of the tail that they came with.
    template <typename Chunk> struct Run
    {
        QList<Chunk> chunks;
        std::size_t size = 0; ///< readings or samples in all of them
        qint64 firstRow = 0;
        qint64 lastRow = 0;
        bool isEmpty() const { return chunks.isEmpty(); }
    };
    struct Sensor
    {
        Run<ReadingChunk> readings;
        Run<SampleChunk> samples;
        std::optional<UtcTime> validAt; ///< of the last reading with a value
    };

    void add(const KeptReading &reading, qint64 row);
    void add(const SampleBlock &block, qint64 row);

    const std::map<int, Sensor> &sensors() const { return m_sensors; }
    static bool isRipe(const Run<ReadingChunk> &run, qint64 row);
    static bool isRipe(const Run<SampleChunk> &run, qint64 row);
    void dropReadings(int number) { m_sensors[number].readings = {}; }
    void dropSamples(int number) { m_sensors[number].samples = {}; }
    void clear() { m_sensors.clear(); }
    /// The tail they came with is gone.
    void forgetRows();

    /// Rows of the tail below this one are needed no more; \a next: where nothing is open.
    qint64 firstRow(qint64 next) const;

private:
    std::map<int, Sensor> m_sensors; ///< by N
};

/// From the earliest to just after the latest time.
TimeSpan spanOf(const ReadingChunk &chunk);
TimeSpan spanOf(const SampleChunk &chunk);

} // namespace gorizont
