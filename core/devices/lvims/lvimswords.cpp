#include "core/devices/lvims/lvimswords.h"

#include <bit>

namespace gorizont::lvims {

namespace {

char lowByte(quint16 word)
{
    return static_cast<char>(word & 0xFF);
}

char highByte(quint16 word)
{
    return static_cast<char>(word >> 8);
}

} // namespace

quint16 Words::word(const Register &entry, int channel, int item) const
{
    return at(entry.at(channel, item));
}

quint32 Words::doubleWord(const Register &entry, int channel, int item) const
{
    const int address = entry.at(channel, item);
    return static_cast<quint32>(at(address + 1)) << 16 | at(address);
}

float Words::real(const Register &entry, int channel, int item) const
{
    return std::bit_cast<float>(doubleWord(entry, channel, item));
}

QString Words::text(const Register &entry) const
{
    QByteArray bytes;
    for (int i = 0; i < entry.size; ++i) {
        const quint16 word = at(entry.address + i);
        bytes.append(lowByte(word)).append(highByte(word));
    }
    const qsizetype end = bytes.indexOf('\0');
    return QString::fromUtf8(end < 0 ? bytes : bytes.left(end));
}

QString Words::ipAddress(const Register &entry) const
{
    const quint32 bytes = doubleWord(entry);
    return QStringLiteral("%1.%2.%3.%4")
        .arg(bytes & 0xFF)
        .arg(bytes >> 8 & 0xFF)
        .arg(bytes >> 16 & 0xFF)
        .arg(bytes >> 24);
}

Words Words::set(const Register &entry, int channel, int item) const
{
    const int offset = entry.at(channel, item) - m_first;
    return {0, offset < 0 ? QList<quint16>() : m_values.mid(offset, entry.size)};
}

QList<quint16> fromDoubleWord(quint32 value)
{
    return {static_cast<quint16>(value & 0xFFFF), static_cast<quint16>(value >> 16)};
}

QList<quint16> fromReal(float value)
{
    return fromDoubleWord(std::bit_cast<quint32>(value));
}

QList<quint16> fromText(const QString &text, int registers)
{
    QByteArray bytes = text.toUtf8();
    if (bytes.size() > 2 * registers) {
        qsizetype end = 2 * registers;
        while (end > 0 && (static_cast<quint8>(bytes.at(end)) & 0xC0) == 0x80) {
            --end;
        }
        bytes.truncate(end);
    }
    bytes.append(2 * registers - bytes.size(), '\0');
    QList<quint16> words;
    for (int i = 0; i < registers; ++i) {
        words.append(
            static_cast<quint16>(static_cast<quint8>(bytes.at(2 * i)) | static_cast<quint8>(bytes.at(2 * i + 1)) << 8));
    }
    return words;
}

} // namespace gorizont::lvims
