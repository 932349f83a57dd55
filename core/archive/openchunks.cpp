#include "core/archive/openchunks.h"

#include <algorithm>

namespace gorizont {

namespace {

template <typename Chunk> void noteRow(OpenChunks::Run<Chunk> &run, qint64 row)
{
    run.firstRow = run.firstRow == 0 ? row : run.firstRow;
    run.lastRow = row;
}

template <typename Chunk> bool isRipeAt(const OpenChunks::Run<Chunk> &run, std::size_t most, qint64 row)
{
    return !run.isEmpty()
        && (run.size >= most || run.chunks.size() > 1 || row - run.firstRow >= OpenChunks::ripeCommits);
}

} // namespace

void OpenChunks::add(const KeptReading &reading, qint64 row)
{
    Sensor &sensor = m_sensors[reading.number];
    Run<ReadingChunk> &run = sensor.readings;
    const bool continues = !run.isEmpty() && reading.time > run.chunks.last().times.back()
        && reading.time - run.chunks.last().times.front() < longest;
    if (!continues) {
        run.chunks.append(ReadingChunk());
    }
    run.chunks.last().append(reading);
    ++run.size;
    noteRow(run, row);
    if (reading.hasValue()) {
        sensor.validAt = reading.time;
    }
}

void OpenChunks::add(const SampleBlock &block, qint64 row)
{
    Run<SampleChunk> &run = m_sensors[block.number].samples;
    const bool isShort = !run.isEmpty() && block.start - run.chunks.last().starts.front() < longest;
    if (!isShort || !run.chunks.last().append(block)) {
        run.chunks.append(SampleChunk());
        run.chunks.last().append(block);
    }
    run.size += static_cast<std::size_t>(std::min(block.x.size(), block.y.size()));
    noteRow(run, row);
}

bool OpenChunks::isRipe(const Run<ReadingChunk> &run, qint64 row)
{
    return isRipeAt(run, ripeReadings, row);
}

bool OpenChunks::isRipe(const Run<SampleChunk> &run, qint64 row)
{
    return isRipeAt(run, ripeSamples, row);
}

qint64 OpenChunks::firstRow(qint64 next) const
{
    qint64 first = next;
    for (const auto &[number, sensor] : m_sensors) {
        first = sensor.readings.isEmpty() ? first : std::min(first, sensor.readings.firstRow);
        first = sensor.samples.isEmpty() ? first : std::min(first, sensor.samples.firstRow);
    }
    return first;
}

void OpenChunks::forgetRows()
{
    for (auto &[number, sensor] : m_sensors) {
        sensor.readings.firstRow = sensor.readings.lastRow = 0;
        sensor.samples.firstRow = sensor.samples.lastRow = 0;
    }
}

TimeSpan spanOf(const ReadingChunk &chunk)
{
    const auto [first, last] = std::minmax_element(chunk.times.begin(), chunk.times.end());
    return {*first, *last + std::chrono::microseconds(1)};
}

TimeSpan spanOf(const SampleChunk &chunk)
{
    return {chunk.starts.front(), chunk.end()};
}

} // namespace gorizont
