#include "core/modbus/registerblock.h"

#include <cstring>

namespace gorizont {

RegisterBlock::RegisterBlock(int base, int count)
    : m_base(base)
    , m_bytes(2 * static_cast<qsizetype>(count), '\0')
{
}

std::optional<QByteArrayView> RegisterBlock::registers(int address, int count) const
{
    const qsizetype first = static_cast<qsizetype>(address) - m_base;
    if (first < 0 || count < 0 || first + count > m_bytes.size() / 2) {
        return std::nullopt;
    }
    return QByteArrayView(m_bytes).sliced(2 * first, 2 * static_cast<qsizetype>(count));
}

void RegisterBlock::write(int index, QByteArrayView bytes)
{
    const qsizetype at = 2 * static_cast<qsizetype>(index);
    if (at >= 0 && at + bytes.size() <= m_bytes.size()) {
        std::memcpy(m_bytes.data() + at, bytes.data(), static_cast<std::size_t>(bytes.size()));
    }
}

} // namespace gorizont
