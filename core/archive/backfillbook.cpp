#include "core/archive/backfillbook.h"

#include "core/archive/gapmath.h"

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

constexpr std::chrono::microseconds shortestPeriod = std::chrono::seconds(1);
constexpr std::chrono::microseconds longestPeriod = std::chrono::hours(12); ///< no recorder measures less often

/// Old files tell times in whole seconds: what of their samples seems to be new by less is not.
constexpr std::chrono::microseconds roundedAway = std::chrono::seconds(2);

/// What is valid and not in the future, by time; of one time only the first.
QList<KeptReading> measured(QList<KeptReading> readings, UtcTime now)
{
    readings.removeIf([now](const KeptReading &reading) { return !reading.hasValue() || reading.time >= now; });
    const auto isEarlier = [](const KeptReading &a, const KeptReading &b) { return a.time < b.time; };
    std::stable_sort(readings.begin(), readings.end(), isEarlier);
    const auto end = std::unique(readings.begin(), readings.end(), [](const KeptReading &a, const KeptReading &b) {
        return a.time == b.time;
    });
    readings.erase(end, readings.end());
    return readings;
}

std::vector<UtcTime> timesOf(const QList<KeptReading> &readings)
{
    std::vector<UtcTime> times;
    for (const KeptReading &reading : readings) {
        times.push_back(reading.time);
    }
    return times;
}

std::chrono::microseconds periodOf(const Backfill &backfill, const std::vector<UtcTime> &times)
{
    return std::clamp(
        backfill.period.count() > 0 ? backfill.period : usualDistance(times), shortestPeriod, longestPeriod);
}

/// What \a times fill of \a gap.
QList<TimeSpan> partsOf(
    const GapBook::Unknown &gap, const std::vector<UtcTime> &times, std::chrono::microseconds period)
{
    TimeSpan span = gap.span;
    if (gap.goesOn) {
        span.to += 2 * period; // nothing is known there that the last value could reach
    }
    QList<TimeSpan> parts = filledParts(span, times, period);
    if (!parts.isEmpty()) {
        parts.last().to = std::min(parts.last().to, gap.span.to);
    }
    return parts;
}

std::chrono::microseconds timeOf(qsizetype samples, double rate)
{
    return std::chrono::microseconds(std::llround(static_cast<double>(samples) * 1e6 / rate));
}

/// The samples of \a block between \a from and \a to.
SampleBlock part(const SampleBlock &block, UtcTime from, UtcTime to)
{
    const auto indexOf = [&block](UtcTime time) {
        const double seconds = std::chrono::duration<double>(time - block.start).count();
        return std::clamp<qsizetype>(std::llround(seconds * block.rate), 0, block.x.size());
    };
    const qsizetype first = indexOf(from);
    const qsizetype count = indexOf(to) - first;
    return {
        block.number,
        block.start + timeOf(first, block.rate),
        block.rate,
        block.scale,
        block.followsPrevious && first == 0,
        block.x.mid(first, count),
        block.y.mid(first, count)};
}

/// Of \a span what none of \a known (ascending) covers.
QList<TimeSpan> uncovered(const TimeSpan &span, const QList<TimeSpan> &known)
{
    QList<TimeSpan> parts;
    UtcTime from = span.from;
    for (const TimeSpan &one : known) {
        if (one.from >= span.to) {
            break;
        }
        if (one.from - from >= roundedAway) {
            parts.append({from, one.from});
        }
        from = std::max(from, one.to);
    }
    if (from == span.from || span.to - from >= roundedAway) {
        parts.append({from, span.to});
    }
    return parts;
}

} // namespace

bool BackfillBook::add(const Backfill &backfill, Sensor &sensor, UtcTime now)
{
    return addRecords(backfill, now) && addReadings(backfill, sensor, now) && addBlocks(backfill, sensor);
}

/// What no readings come with fills gaps by its times alone. Those that came before count as well: a recorder is often
/// asked for the new ones only.
bool BackfillBook::addRecords(const Backfill &backfill, UtcTime now)
{
    TimeSpan span{now, UtcTime::min()};
    for (const DeviceRecord &record : backfill.records) {
        bool isNew = false;
        if (!m_store.putRecord(record, &isNew)) {
            return false;
        }
        span.from = std::min(span.from, record.start);
        span.to = std::max(span.to, record.start);
    }
    if (!backfill.readings.isEmpty() || backfill.records.isEmpty() || backfill.source.isEmpty()) {
        return true;
    }
    const auto times = m_store.recordTimes(
        backfill.number, {span.from - 2 * longestPeriod, std::min(span.to + 2 * longestPeriod, now)});
    if (!times || times->empty()) {
        return times.has_value();
    }
    const auto period = periodOf(backfill, *times);
    const auto unknown = m_gaps.unknown(backfill.number, {times->front(), times->back() + 2 * period}, now);
    QList<TimeSpan> parts;
    for (const GapBook::Unknown &gap : unknown.value_or(QList<GapBook::Unknown>())) {
        parts += partsOf(gap, *times, period);
    }
    return unknown && m_gaps.fill(backfill.number, parts, backfill.source);
}

bool BackfillBook::addReadings(const Backfill &backfill, Sensor &sensor, UtcTime now)
{
    const QList<KeptReading> readings = measured(backfill.readings, now);
    if (readings.isEmpty()) {
        return true;
    }
    const TimeSpan span{readings.first().time, readings.last().time};
    const auto recorded = m_store.recordTimes(
        backfill.number, {span.from - 2 * longestPeriod, std::min(span.to + 2 * longestPeriod, now)});
    if (!recorded || !widen(backfill.number, sensor, span.from, now)) {
        return false;
    }
    const auto period = periodOf(backfill, recorded->size() > 1 ? *recorded : timesOf(readings));
    const auto unknown = m_gaps.unknown(backfill.number, {span.from - 2 * period, span.to + 2 * period}, now);
    QList<KeptReading> fresh;
    QList<TimeSpan> parts;
    for (const GapBook::Unknown &gap : unknown.value_or(QList<GapBook::Unknown>())) {
        QList<KeptReading> inside = readings;
        const bool isFirstFresh = gap.followsFilled || gap.span.from == sensor.widenedTo;
        inside.removeIf([&gap, isFirstFresh](const KeptReading &reading) {
            return reading.time < gap.span.from || reading.time >= gap.span.to
                || (reading.time == gap.span.from && !isFirstFresh);
        });
        parts += partsOf(gap, timesOf(inside), period);
        fresh += inside;
    }
    return unknown && write(backfill.number, fresh, sensor) && m_gaps.fill(backfill.number, parts, backfill.source);
}

/// What was never known of a sensor becomes a gap as soon as anything is.
bool BackfillBook::widen(int number, Sensor &sensor, UtcTime from, UtcTime now)
{
    if (sensor.known && sensor.known->from <= from) {
        return true;
    }
    if (!m_gaps.layBefore(number, from, sensor.known ? sensor.known->from : now)) {
        return false;
    }
    KnownSensor known = sensor.known.value_or(KnownSensor{from, from, 0, 0});
    known.from = from;
    sensor.known = known;
    sensor.widenedTo = from;
    return m_store.putSensor(number, known);
}

bool BackfillBook::write(int number, const QList<KeptReading> &readings, Sensor &sensor)
{
    if (readings.isEmpty()) {
        return true;
    }
    OpenChunks open;
    for (const KeptReading &reading : readings) {
        open.add(reading, 1);
    }
    for (const ReadingChunk &chunk : open.sensors().at(number).readings.chunks) {
        if (!m_store.appendChunk(ChunkKind::FullRate, number, spanOf(chunk), encodeChunk(chunk, sensor.offsets))
            || !m_rollups.add(number, chunk, sensor.offsets)) {
            return false;
        }
    }
    m_added += readings.size();
    if (sensor.known->until >= readings.last().time) {
        return true;
    }
    sensor.known->until = readings.last().time;
    return m_store.putSensor(number, *sensor.known);
}

bool BackfillBook::addBlocks(const Backfill &backfill, Sensor &sensor)
{
    OpenChunks open;
    for (const SampleBlock &block : backfill.blocks) {
        const TimeSpan span{block.start, block.start + timeOf(block.x.size(), block.rate)};
        const auto stored =
            m_store.chunkSpans(ChunkKind::Samples, backfill.number, {span.from - 2 * OpenChunks::longest, span.to});
        if (!stored) {
            return false;
        }
        QList<TimeSpan> known = *stored + sensor.openSamples;
        std::sort(known.begin(), known.end(), [](const TimeSpan &a, const TimeSpan &b) { return a.from < b.from; });
        for (const TimeSpan &fresh : uncovered(span, known)) {
            const SampleBlock samples = part(block, fresh.from, fresh.to);
            open.add(samples, 1);
            m_added += samples.x.size();
        }
    }
    for (const auto &[number, run] : open.sensors()) {
        for (const SampleChunk &chunk : run.samples.chunks) {
            if (!m_store.appendChunk(ChunkKind::Samples, number, spanOf(chunk), encodeChunk(chunk))
                || !m_rollups.add(number, chunk)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace gorizont
