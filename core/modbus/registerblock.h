#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <optional>

namespace gorizont {

/// The registers of one unit, kept as the bytes that go over the wire, so that an answer is one copy. Pure.
class RegisterBlock
{
public:
    static constexpr int addressSpace = 65536;

    /// \a count registers of zeros; the first has address \a base. Addresses below the base are outside: a client that
    /// counts from the wrong end is told so by exception 02 instead of reading everything one register late.
    RegisterBlock(int base, int count);

    int base() const { return m_base; }
    int count() const { return static_cast<int>(m_bytes.size() / 2); }

    /// The bytes of registers \a address … \a address + \a count − 1; empty when not all of them are in the block.
    std::optional<QByteArrayView> registers(int address, int count) const;

    /// \a index counts registers from the start of the block, whatever the base. What does not fit is not written.
    void write(int index, QByteArrayView bytes);

private:
    int m_base = 0;
    QByteArray m_bytes;
};

} // namespace gorizont
