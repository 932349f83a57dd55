#include "core/modbus/registerblock.h"

#include <QtEndian>

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

template <typename T> void RegisterBlock::store(int index, T value)
{
    const qsizetype at = 2 * static_cast<qsizetype>(index);
    if (at >= 0 && at + static_cast<qsizetype>(sizeof(T)) <= m_bytes.size()) {
        qToLittleEndian(value, m_bytes.data() + at);
    }
}

void RegisterBlock::setWord(int index, quint16 value)
{
    store(index, value);
}

void RegisterBlock::setDword(int index, quint32 value)
{
    store(index, value);
}

} // namespace gorizont
