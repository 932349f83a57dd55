#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <optional>

namespace gorizont {

/// The input registers of one unit, kept as the bytes that go over the wire, so that an answer is one copy.
/// The contents are a little-endian byte stream (manual 000, 10.3: "all numbers low byte first"): on the wire every
/// register is byte-swapped and the 32-bit channel word comes low byte first. Pure.
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

    /// \a index counts registers from the start of the block, whatever the base. Outside the block nothing happens.
    void setWord(int index, quint16 value);
    void setDword(int index, quint32 value);

private:
    template <typename T> void store(int index, T value);

    int m_base = 0;
    QByteArray m_bytes;
};

} // namespace gorizont
