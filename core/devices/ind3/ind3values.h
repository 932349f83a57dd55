#pragma once

#include "core/values/reading.h"

#include <QByteArray>
#include <QString>

/// What the three protocols of ИН-Д2/3/7/9 have in common. «Обмен данными с измерителем угла наклона версии 2.xx»,
/// document version 1.2; spec/ind3.md.
namespace gorizont::ind3 {

/// The angle block of protocols 2.10 and 2.11, of readings and of zero offsets alike:
///
///     D0 D1 D2 | D3 D4 D5
///        Y     |    X          the document labels both halves X; its examples settle it
///
///     D0  fraction, 1/256
///     D1  integer part, bits 7…0
///     D2  bit 7: negative (sign and magnitude) · bit 6: unit, 0 arc-seconds, 1 arc-minutes · bits 5…0: integer, 13…8
///
/// Arc-seconds. Empty: not six bytes.
std::optional<Tilt> decodeAngleBlock(QByteArrayView block);

/// Rounds to 1/256 of the unit; arc-seconds below 16384″, arc-minutes above. Empty: not below 16384′.
std::optional<QByteArray> encodeAngleBlock(const Tilt &tilt);

constexpr int mostTicksCode = 6;
constexpr int mostPeriodCode = 3;

/// Speed codes 1…8 of `9C 01`, `9C 02` and register 20, baud.
std::optional<int> baudOfCode(int code);
std::optional<int> codeOfBaud(int baud);

/// Averaging ticks, codes 0…6 of `9C 0C`, `9C 0D` and register 23: 1…64, powers of two; 32 from the factory.
std::optional<int> ticksOfCode(int code);
std::optional<int> codeOfTicks(int ticks);

/// Averaging period, codes 0…3 of `9C 0E`, `9C 0F` and register 22: 10, 20, 50, 100 ms; 50 from the factory.
std::optional<std::chrono::milliseconds> periodOfCode(int code);
std::optional<int> codeOfPeriod(std::chrono::milliseconds period);

/// The name is stored in Windows-1251, 1…16 bytes without a terminator. Empty: does not fit, holds a character that is
/// not in Windows-1251, or is empty (its answer would be the echo of the question).
std::optional<QByteArray> encodeName(const QString &name);
QString decodeName(QByteArrayView bytes);

constexpr qsizetype longestName = 16;

/// Number of the software revision, as shown whole (4144) and in parts (type 2, revision 48).
struct Revision
{
    quint16 number = 0;

    int type() const { return number >> 11; } ///< of software, high 5 bits
    int revision() const { return number & 0x7FF; } ///< low 11 bits
    bool operator==(const Revision &) const = default;
};

inline bool isAddress(int address)
{
    return address >= 1 && address <= 255;
}

} // namespace gorizont::ind3
