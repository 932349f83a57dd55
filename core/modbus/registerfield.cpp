#include "core/modbus/registerfield.h"

#include "core/modbus/registervalue.h"

#include <QtEndian>

#include <bit>

namespace gorizont {

namespace {

quint32 floatBits(double value)
{
    constexpr quint32 quietNaN = 0x7FC00000;
    const bool fits = std::isfinite(value) && std::abs(value) <= double{std::numeric_limits<float>::max()};
    return fits ? std::bit_cast<quint32>(static_cast<float>(value)) : quietNaN;
}

template <typename T> qsizetype store(T value, RegisterOrder order, char *bytes)
{
    order == RegisterOrder::LowByteFirst ? qToLittleEndian(value, bytes) : qToBigEndian(value, bytes);
    return sizeof(T);
}

} // namespace

RegisterBytes::RegisterBytes(double value, double scale, RegisterType type, RegisterOrder order)
{
    switch (type) {
    case RegisterType::Int16: m_size = store(registerValue<qint16>(value, scale), order, m_bytes.data()); break;
    case RegisterType::UInt16: m_size = store(registerValue<quint16>(value, scale), order, m_bytes.data()); break;
    case RegisterType::UInt32: m_size = store(registerValue<quint32>(value, scale), order, m_bytes.data()); break;
    case RegisterType::UInt64: m_size = store(registerValue<quint64>(value, scale), order, m_bytes.data()); break;
    case RegisterType::Float32: m_size = store(floatBits(value * scale), order, m_bytes.data()); break;
    }
}

} // namespace gorizont
