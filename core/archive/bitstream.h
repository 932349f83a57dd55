#pragma once

#include <QByteArray>

#include <algorithm>
#include <bit>
#include <utility>

namespace gorizont {

/// Bits, the lowest first, appended to bytes. Pure.
class BitWriter
{
public:
    void put(quint64 value, int count)
    {
        if (count > 32) {
            putFew(value & 0xFFFFFFFFU, 32);
            value >>= 32;
            count -= 32;
        }
        putFew(value, count);
    }

    QByteArray take()
    {
        if (m_filled > 0) {
            flushByte();
        }
        m_filled = 0;
        return std::exchange(m_bytes, {});
    }

private:
    void putFew(quint64 value, int count)
    {
        m_open |= value << m_filled;
        m_filled += count;
        while (m_filled >= 8) {
            flushByte();
        }
    }
    void flushByte()
    {
        m_bytes.append(static_cast<char>(m_open & 0xFF));
        m_open >>= 8;
        m_filled -= 8;
    }

    QByteArray m_bytes;
    quint64 m_open = 0;
    int m_filled = 0; ///< bits of m_open; < 8 between calls
};

/// Takes them again. Beyond the end everything is 0 and isGood() is false.
class BitReader
{
public:
    explicit BitReader(QByteArrayView bytes)
        : m_bytes(bytes)
    {
    }

    quint64 take(int count)
    {
        if (count > 32) {
            const quint64 low = takeFew(32);
            return low | (takeFew(count - 32) << 32);
        }
        return takeFew(count);
    }

    /// How many ones come next, at most \a most (≤ 32); the zero that ends fewer is taken too.
    int takeOnes(int most)
    {
        fill();
        const int ones = std::min(std::countr_one(m_open), most);
        drop(ones < most ? ones + 1 : ones);
        return ones;
    }

    bool isGood() const { return m_isGood; }
    /// Everything was taken but the bits that fill the last byte.
    bool isAtEnd() const { return m_at == m_bytes.size() && m_filled < 8; }

private:
    quint64 takeFew(int count)
    {
        fill();
        const quint64 value = m_open & ((quint64{1} << count) - 1);
        drop(count);
        return value;
    }
    void fill()
    {
        while (m_filled <= 56 && m_at < m_bytes.size()) {
            m_open |= static_cast<quint64>(static_cast<quint8>(m_bytes[m_at++])) << m_filled;
            m_filled += 8;
        }
    }
    void drop(int count)
    {
        if (count > m_filled) {
            m_isGood = false;
            m_open = 0;
            m_filled = 0;
            return;
        }
        m_open >>= count;
        m_filled -= count;
    }

    QByteArrayView m_bytes;
    qsizetype m_at = 0;
    quint64 m_open = 0;
    int m_filled = 0;
    bool m_isGood = true;
};

} // namespace gorizont
