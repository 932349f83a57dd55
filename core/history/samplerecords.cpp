#include "core/history/samplerecords.h"

#include <QDir>
#include <QtEndian>

#include <algorithm>
#include <numbers>

namespace gorizont {

namespace {

/// Raw units are 1/8 arc-second of the tilt that would feel the same; their sign is opposite to the acceleration.
double scaleOf(double gravity)
{
    constexpr double arcSeconds = 1.0 / 8;
    return -arcSeconds / 3600 * std::numbers::pi / 180 * gravity * 1000;
}

} // namespace

SampleRecords::SampleRecords(const QString &folder, const QTimeZone &zone, double gravity)
    : m_scale(scaleOf(gravity))
{
    for (const QFileInfo &info : QDir(folder).entryInfoList({QStringLiteral("*.wrd")}, QDir::Files, QDir::Name)) {
        const std::optional<SampleFileName> name = parseSampleFileName(info.fileName());
        if (name) {
            const QDateTime local(name->start.date(), name->start.time(), zone);
            const UtcTime start(std::chrono::milliseconds(local.toMSecsSinceEpoch()));
            m_files.append({info.filePath(), start, info.size() / 2, name->number, name->axis});
        }
    }
    std::stable_sort(m_files.begin(), m_files.end(), [](const File &a, const File &b) { return a.start < b.start; });
}

std::optional<TimeSpan> SampleRecords::span() const
{
    std::optional<TimeSpan> span;
    for (const File &file : m_files) {
        span = TimeSpan{span ? span->from : file.start, std::max(span ? span->to : file.end(), file.end())};
    }
    return span;
}

bool SampleRecords::readFile(const File &file, double scale, UtcTime from, UtcTime to, const Take &take)
{
    QFile bytes(file.path);
    if (!bytes.open(QIODevice::ReadOnly)) {
        return true;
    }
    const qint64 first = from <= file.start ? 0 : (from - file.start + period - std::chrono::microseconds(1)) / period;
    const qint64 count = std::min<qint64>(file.samples, (to - file.start) / period + 1) - first;
    if (count <= 0 || !bytes.seek(first * 2)) {
        return true;
    }
    const QByteArray raw = bytes.read(count * 2);
    for (qint64 i = 0; i < raw.size() / 2; ++i) {
        const UtcTime time = file.start + (first + i) * period;
        const double value = scale * qFromLittleEndian<qint16>(raw.constData() + 2 * i);
        if (time < to && !take(time, value)) {
            return false;
        }
    }
    return true;
}

void SampleRecords::read(const SeriesKey &key, UtcTime from, UtcTime to, const Take &take) const
{
    const char axis = key.quantity == Quantity::SampleX ? 'X' : 'Y';
    for (const File &file : m_files) {
        const bool isWanted = file.number == key.number && file.axis == axis && file.start < to && file.end() > from;
        if (isWanted && !readFile(file, m_scale, from, to, take)) {
            return;
        }
    }
}

bool SampleRecords::readPair(const File &x, const File &y, const TakeBlock &take) const
{
    constexpr qsizetype samplesOfBlock = 32'000;
    QFile bytesX(x.path);
    QFile bytesY(y.path);
    if (!bytesX.open(QIODevice::ReadOnly) || !bytesY.open(QIODevice::ReadOnly)) {
        return true;
    }
    const double rate = 1e6 / static_cast<double>(period.count());
    for (qint64 at = 0;; at += samplesOfBlock) {
        SampleBlock block{x.number, x.start + at * period, rate, m_scale, at > 0, {}, {}};
        const QByteArray rawX = bytesX.read(2 * samplesOfBlock);
        const QByteArray rawY = bytesY.read(2 * samplesOfBlock);
        for (qsizetype i = 0; i < std::min(rawX.size(), rawY.size()) / 2; ++i) {
            block.x.append(qFromLittleEndian<qint16>(rawX.constData() + 2 * i));
            block.y.append(qFromLittleEndian<qint16>(rawY.constData() + 2 * i));
        }
        if (block.x.isEmpty()) {
            return true;
        }
        if (!take(block)) {
            return false;
        }
    }
}

void SampleRecords::readBlocks(const TakeBlock &take) const
{
    for (const File &x : m_files) {
        const auto y = std::find_if(m_files.begin(), m_files.end(), [&x](const File &file) {
            return file.axis == 'Y' && file.number == x.number && file.start == x.start;
        });
        if (x.axis == 'X' && y != m_files.end() && !readPair(x, *y, take)) {
            return;
        }
    }
}

} // namespace gorizont
