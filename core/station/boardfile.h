#pragma once

#include "core/station/correction.h"
#include "core/station/stationcomplaint.h"

#include <QByteArray>

#include <chrono>

namespace gorizont::station {

enum class BoardKind : quint8 { L154, Fastwel };

/// A letter in one of the strings of a board: which parameter stands at which place.
struct BoardInput
{
    int channel = 0; ///< place in the string, 0…
    ParameterId parameter;
    bool operator==(const BoardInput &) const = default;
};

/// ACK.LCD or ACK.FWL (manual 004, sections 3.4 and 3.5): where raw values come from. The boards are gone; addresses, interrupts
/// and gains are read and without effect.
struct BoardConfig
{
    static constexpr int mostAnalogue = 64; ///< the boards had 16
    static constexpr int mostDigital = 32; ///< bits of DIG; the boards had 8

    BoardKind kind = BoardKind::L154;
    double switchRate =
        1000; ///< Hz: measurements of all channels together; LCD: 1 MHz ÷ both dividers, FWL: 1 ÷ period
    int hardwareAverage = 1; ///< FWL: measurements that one value is the mean of
    int instantSeconds = 1; ///< seconds in an instantaneous value, 1…3600
    double gate = 1; ///< s: LCD, gate of the frequency input
    bool isTest = false;
    bool sendsInstant = false; ///< of telegrams, which are not documented; without effect
    std::optional<ParameterId> frequency; ///< LCD: what the frequency input measures
    QList<BoardInput> analogue;
    QList<BoardInput> digital; ///< `O` is the sensor of liquid precipitation
    int digitalPlaces = 0; ///< length of the string of digital inputs, with the places where nothing is connected
    int firstBit = 0; ///< of DIG, where digital input 0 of this board stands
    QList<BoardInput> order; ///< of processing; channel is the place

    /// Hz: what one analogue channel gets of switchRate.
    double channelRate() const { return analogue.isEmpty() ? switchRate : switchRate / double(analogue.size()); }
    bool operator==(const BoardConfig &) const = default;
};

/// The letter of the sensor of liquid precipitation among the digital inputs.
inline constexpr QChar precipitationCode{u'O'};

/// ACK.LCD: 14 values, ACK.FWL: 12, or 10 without the two that only the AI16-5A has. One value a line, the rest comment, when
/// there are as many lines; else the fields of all lines one after another. In the letter strings a dash, a point, an underscore and
/// (in quotes) a blank are places where nothing is connected; the n-th time of a letter is the parameter n of that code, counted
/// through the analogue inputs, the frequency input and the digital ones. Empty: the number of values is wrong.
std::optional<BoardConfig> readBoard(
    BoardKind kind, const QString &file, const QByteArray &bytes, Complaints &complaints);

/// The letters and the bits of \a board count on behind those of \a first: T of the second board is T 2 when the first one has a T.
/// An L-154 keeps 8 bits for itself, also when its string is shorter.
void countOn(BoardConfig &board, const BoardConfig &first);

} // namespace gorizont::station
