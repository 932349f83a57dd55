#include "core/archive/archivebytes.h"

#include <QtEndian>

#include <array>
#include <bit>

namespace gorizont {

namespace {

constexpr qsizetype sumBytes = 4;

/// Four tables, so that four bytes are taken at a time.
constexpr std::array<std::array<quint32, 256>, 4> makeTables()
{
    std::array<std::array<quint32, 256>, 4> tables{};
    for (quint32 i = 0; i < 256; ++i) {
        quint32 sum = i;
        for (int bit = 0; bit < 8; ++bit) {
            sum = (sum >> 1) ^ (sum & 1 ? 0xEDB88320U : 0U);
        }
        tables[0][i] = sum;
    }
    for (std::size_t table = 1; table < 4; ++table) {
        for (std::size_t i = 0; i < 256; ++i) {
            tables[table][i] = (tables[table - 1][i] >> 8) ^ tables[0][tables[table - 1][i] & 0xFF];
        }
    }
    return tables;
}

constexpr auto tables = makeTables();

} // namespace

quint32 crc32(QByteArrayView bytes)
{
    quint32 sum = 0xFFFFFFFFU;
    qsizetype at = 0;
    for (; at + 4 <= bytes.size(); at += 4) {
        sum ^= qFromLittleEndian<quint32>(bytes.data() + at);
        sum =
            tables[3][sum & 0xFF] ^ tables[2][(sum >> 8) & 0xFF] ^ tables[1][(sum >> 16) & 0xFF] ^ tables[0][sum >> 24];
    }
    for (; at < bytes.size(); ++at) {
        sum = (sum >> 8) ^ tables[0][(sum ^ static_cast<quint8>(bytes[at])) & 0xFF];
    }
    return ~sum;
}

void ArchiveBytes::number(quint64 value)
{
    while (value >= 0x80) {
        byte(static_cast<quint8>(value | 0x80));
        value >>= 7;
    }
    byte(static_cast<quint8>(value));
}

void ArchiveBytes::real(double value)
{
    const auto bits = qToLittleEndian(std::bit_cast<quint64>(value));
    m_bytes.append(reinterpret_cast<const char *>(&bits), sizeof bits);
}

void ArchiveBytes::piece(QByteArrayView bytes)
{
    number(static_cast<quint64>(bytes.size()));
    raw(bytes);
}

QByteArray ArchiveBytes::sealed() const
{
    const auto sum = qToLittleEndian(crc32(m_bytes));
    return m_bytes + QByteArray(reinterpret_cast<const char *>(&sum), sizeof sum);
}

ArchiveCursor ArchiveCursor::ofSealed(QByteArrayView bytes)
{
    ArchiveCursor cursor({});
    if (bytes.size() <= sumBytes) {
        cursor.fail();
        return cursor;
    }
    const QByteArrayView content = bytes.chopped(sumBytes);
    if (qFromLittleEndian<quint32>(bytes.data() + content.size()) != crc32(content)) {
        cursor.fail();
        return cursor;
    }
    return ArchiveCursor(content);
}

void ArchiveCursor::fail()
{
    m_isGood = false;
    m_bytes = {};
}

quint8 ArchiveCursor::byte()
{
    const QByteArrayView one = raw(1);
    return one.isEmpty() ? quint8{0} : static_cast<quint8>(one[0]);
}

quint64 ArchiveCursor::number()
{
    quint64 value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const quint8 next = byte();
        const quint64 bits = next & 0x7F;
        if (shift == 63 && bits > 1) {
            break;
        }
        value |= bits << shift;
        if (!(next & 0x80)) {
            return m_isGood ? value : 0;
        }
    }
    fail();
    return 0;
}

double ArchiveCursor::real()
{
    const QByteArrayView bytes = raw(sizeof(quint64));
    return bytes.isEmpty() ? 0 : std::bit_cast<double>(qFromLittleEndian<quint64>(bytes.data()));
}

QByteArrayView ArchiveCursor::raw(quint64 count)
{
    if (count > static_cast<quint64>(m_bytes.size())) {
        fail();
        return {};
    }
    const QByteArrayView piece = m_bytes.first(static_cast<qsizetype>(count));
    m_bytes = m_bytes.sliced(static_cast<qsizetype>(count));
    return piece;
}

} // namespace gorizont
