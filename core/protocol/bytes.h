#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QtEndian>

#include <optional>

namespace gorizont {

/// Reads a little-endian integer at \a offset; empty when it does not lie wholly inside \a bytes.
template <typename T> std::optional<T> readLittle(QByteArrayView bytes, qsizetype offset)
{
    if (offset < 0 || offset > bytes.size() || bytes.size() - offset < static_cast<qsizetype>(sizeof(T))) {
        return std::nullopt;
    }
    return qFromLittleEndian<T>(bytes.data() + offset);
}

/// Reads a big-endian integer at \a offset; empty when it does not lie wholly inside \a bytes.
template <typename T> std::optional<T> readBig(QByteArrayView bytes, qsizetype offset)
{
    if (offset < 0 || offset > bytes.size() || bytes.size() - offset < static_cast<qsizetype>(sizeof(T))) {
        return std::nullopt;
    }
    return qFromBigEndian<T>(bytes.data() + offset);
}

template <typename T> void appendLittle(QByteArray &bytes, T value)
{
    const T little = qToLittleEndian(value);
    bytes.append(reinterpret_cast<const char *>(&little), sizeof little);
}

template <typename T> void appendBig(QByteArray &bytes, T value)
{
    const T big = qToBigEndian(value);
    bytes.append(reinterpret_cast<const char *>(&big), sizeof big);
}

inline void appendByte(QByteArray &bytes, int value)
{
    bytes.append(static_cast<char>(static_cast<unsigned char>(value)));
}

inline quint8 byteAt(QByteArrayView bytes, qsizetype offset)
{
    return static_cast<quint8>(bytes.at(offset));
}

} // namespace gorizont
