#pragma once

#include <QByteArray>

#include <optional>

namespace gorizont {

/// CRC-32 of IEEE 802.3 (that of zip and PNG): of "123456789" it is CBF43926h.
quint32 crc32(QByteArrayView bytes);

inline quint64 zigzag(qint64 value)
{
    return (static_cast<quint64>(value) << 1) ^ static_cast<quint64>(value >> 63);
}
inline qint64 unzigzag(quint64 value)
{
    return static_cast<qint64>((value >> 1) ^ (0 - (value & 1)));
}

/// Appends the pieces of which everything in the archive is made. Numbers of variable length: seven bits a byte, the
/// lowest first, the top bit says that more follow. All else is little-endian.
class ArchiveBytes
{
public:
    void byte(quint8 value) { m_bytes.append(static_cast<char>(value)); }
    void number(quint64 value);
    void signedNumber(qint64 value) { number(zigzag(value)); }
    void real(double value);
    void raw(QByteArrayView bytes) { m_bytes.append(bytes); }
    /// Its length, then the bytes.
    void piece(QByteArrayView bytes);

    const QByteArray &bytes() const { return m_bytes; }
    /// What was appended and its CRC-32.
    QByteArray sealed() const;

private:
    QByteArray m_bytes;
};

/// Takes the pieces again. Once a piece is not there, every further one is empty or 0 and isGood() is false.
class ArchiveCursor
{
public:
    explicit ArchiveCursor(QByteArrayView bytes)
        : m_bytes(bytes)
    {
    }
    /// Of what ArchiveBytes::sealed() made; not good where the check sum is wrong.
    static ArchiveCursor ofSealed(QByteArrayView bytes);

    quint8 byte();
    quint64 number();
    qint64 signedNumber() { return unzigzag(number()); }
    double real();
    QByteArrayView raw(quint64 count);
    QByteArrayView piece() { return raw(number()); }

    void fail();
    bool isGood() const { return m_isGood; }
    bool isAtEnd() const { return m_bytes.isEmpty(); }

private:
    QByteArrayView m_bytes; ///< what is left
    bool m_isGood = true;
};

} // namespace gorizont
