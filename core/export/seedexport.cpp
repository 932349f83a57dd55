#include "core/export/seedexport.h"

#include <algorithm>
#include <cmath>

namespace gorizont {

using namespace std::chrono_literals;

bool SeedExport::writeAll()
{
    const QList<SensorConfig> sensors = exportedAccelerometers(m_request);
    for (qsizetype i = 0; i < sensors.size(); ++i) {
        if (!writeSensor(sensors.at(i).number, double(i), double(sensors.size()))) {
            return false;
        }
    }
    return true;
}

bool SeedExport::writeNotes()
{
    return writeBeside(m_request.path + QStringLiteral(".txt"), seedNotes(m_request, m_scales));
}

bool SeedExport::writeSensor(int number, double before, double total)
{
    const QString location = seedLocation(number);
    SeedPacker x(m_request.seed, location, SeedPacker::Axis::X);
    SeedPacker y(m_request.seed, location, SeedPacker::Axis::Y);
    std::optional<UtcTime> last;
    constexpr auto piece = 6h;
    constexpr auto longestBlock = 1min; // what begins before the range may end in it
    for (UtcTime from = m_request.from - longestBlock; from < m_request.to; from += piece) {
        const auto blocks = wait(m_source.blocks(number, from, std::min(from + piece, m_request.to)));
        if (!blocks) {
            return false;
        }
        for (const SampleBlock &block : *blocks) {
            if (last && block.start <= *last) {
                continue;
            }
            last = block.start;
            if (!writeBlock(block, x, y)) {
                return false;
            }
        }
        const double share =
            double((from + piece - m_request.from).count()) / double((m_request.to - m_request.from).count());
        if (!report((before + std::min(share, 1.0)) / total)) {
            return false;
        }
    }
    return write(x.flush() + y.flush());
}

bool SeedExport::writeBlock(const SampleBlock &block, SeedPacker &x, SeedPacker &y)
{
    const qsizetype size = std::min(block.x.size(), block.y.size());
    const auto indexAt = [&](UtcTime time) {
        const double seconds = std::chrono::duration<double>(time - block.start).count();
        return std::clamp(static_cast<qsizetype>(std::ceil(seconds * block.rate - 1e-6)), qsizetype(0), size);
    };
    const qsizetype first = indexAt(m_request.from);
    const qsizetype count = indexAt(m_request.to) - first;
    if (count <= 0) {
        return true;
    }
    const bool isNew = m_scales.isEmpty() || m_scales.last().number != block.number
        || m_scales.last().scale != block.scale || m_scales.last().rate != block.rate;
    if (isNew) {
        m_scales << SeedScale{block.number, std::max(block.start, m_request.from), block.rate, block.scale};
    }
    m_result.rows += static_cast<quint64>(count);
    return write(x.add(block, first, count) + y.add(block, first, count));
}

} // namespace gorizont
