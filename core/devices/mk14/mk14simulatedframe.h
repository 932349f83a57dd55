#pragma once

#include <QByteArray>

/// Frames as the simulated station makes and reads them; written apart from the codec.
namespace gorizont::mk14::simulated {

/// Modulo 256.
inline int sumOf(const QByteArray &bytes)
{
    int sum = 0;
    for (const char byte : bytes) {
        sum += static_cast<unsigned char>(byte);
    }
    return sum & 0xFF;
}

inline QByteArray summed(QByteArray bytes)
{
    return bytes + static_cast<char>(static_cast<unsigned char>(-sumOf(bytes)));
}

inline void appendWord(QByteArray &bytes, quint32 word)
{
    for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(static_cast<unsigned char>(word >> shift & 0xFF));
    }
}

inline quint32 wordAt(const QByteArray &bytes, qsizetype at)
{
    quint32 word = 0;
    for (int i = 3; i >= 0; --i) {
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return word;
}

inline int byteOf(const QByteArray &bytes, qsizetype at)
{
    return static_cast<unsigned char>(bytes[at]);
}

inline QByteArray header(int address, int length, quint32 digital)
{
    QByteArray bytes("\xBB");
    bytes += static_cast<char>(static_cast<unsigned char>(address));
    bytes += '\0';
    bytes += static_cast<char>(static_cast<unsigned char>(length));
    appendWord(bytes, digital);
    return summed(bytes);
}

} // namespace gorizont::mk14::simulated
