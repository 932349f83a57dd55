#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>

#include <chrono>

/// АН-Д3 on the wire, pure (manufacturer's «Обмен данными с акселерометром-наклономером АН-Д3», version 1.03;
/// spec/and3.md). RS-485, 8N1, 115200, half duplex.
///
///     request  AA OP B1 B2 CL CH
///     answer   AA OP data… CL CH
///
///     AA     address 1…255; 00 is broadcast: obeyed by all, answered by none
///     OP     the operation; it decides how many bytes of data its answer carries
///     B1 B2  arguments of the operation
///     CL CH  CRC-16/CCITT-FALSE of everything before it, low byte first
namespace gorizont::and3 {

enum class Op : quint8 {
    Information = 36, ///< B1 an InformationKind; answers 4 bytes
    Mode = 50, ///< B1 a ModeBit, B2 its value; answers nothing but the frame
    Reset = 99, ///< of the controller, after 1 s; answers 0 or 2 bytes, the document says both
    ComplexRead = 201, ///< answers 18 bytes, see ComplexRead
    ReadPackets = 203, ///< B1 first cell of the ring, B2 how many; answers 148 bytes each
    RingState = 205, ///< B1 threshold, B2 flags; answers no data
    ClearRing = 206, ///< clears and stops it; answers no data
    WriteConfiguration = 220, ///< temporary → non-volatile; answers 2 bytes
    ReadConfiguration = 221, ///< B1 a ConfigurationKind; answers 32 bytes
    SetByte = 224, ///< of the temporary configuration: B1 index, B2 value; answers no data
    CopyConfiguration = 225, ///< current → temporary; answers no data
};

enum class InformationKind : quint8 {
    SystemClock = 0,
    HeaterPower = 2,
    FanPower = 3,
    Firmware = 4, ///< byte 0 build, 1 sub-version, 2 version
    InnerTransducer = 5, ///< its address and command
    ResponseTime = 7, ///< of the inner transducer
};

enum class ModeBit : quint8 {
    RecordingStopped = 6, ///< 1 stops recording into the ring, 0 runs it
    RebootAcknowledged = 101, ///< 1 acknowledges the reboot flag
};

enum class ConfigurationKind : quint8 { Current = 0, Temporary = 1, NonVolatile = 2 };

constexpr qsizetype headerSize = 2; ///< AA OP
constexpr qsizetype sumSize = 2; ///< CL CH
constexpr qsizetype packetSize = 148; ///< bytes of one packet of the ring
constexpr int ringCells = 128; ///< packets in the ring
constexpr std::chrono::milliseconds leastSilence{10}; ///< between any two exchanges, packet reads included (observed)
constexpr int longestRead = 4; ///< packets asked for at once: 52 ms at 115200

struct Request
{
    quint8 address = 1;
    Op op = Op::ComplexRead;
    quint8 b1 = 0;
    quint8 b2 = 0;

    static Request information(quint8 address, InformationKind kind)
    {
        return {address, Op::Information, quint8(kind), 0};
    }
    static Request mode(quint8 address, ModeBit bit, bool value) { return {address, Op::Mode, quint8(bit), value}; }
    static Request reset(quint8 address) { return {address, Op::Reset, key1, key2}; }
    static Request complexRead(quint8 address) { return {address, Op::ComplexRead, 0, 0}; }
    /// \a firstCell 0…127, \a count 1…longestRead. What happens across cell 127 is not specified: do not ask for it.
    static Request packets(quint8 address, quint8 firstCell, quint8 count)
    {
        return {address, Op::ReadPackets, firstCell, count};
    }
    static Request ringState(quint8 address, quint8 threshold, quint8 flags)
    {
        return {address, Op::RingState, threshold, flags};
    }
    static Request clearRing(quint8 address) { return {address, Op::ClearRing, 0, 0}; }
    static Request writeConfiguration(quint8 address) { return {address, Op::WriteConfiguration, key1, key2}; }
    static Request configuration(quint8 address, ConfigurationKind kind)
    {
        return {address, Op::ReadConfiguration, quint8(kind), 0};
    }
    static Request setByte(quint8 address, quint8 index, quint8 value) { return {address, Op::SetByte, index, value}; }
    static Request copyConfiguration(quint8 address) { return {address, Op::CopyConfiguration, 0, 0}; }

    QByteArray toBytes() const;
    bool operator==(const Request &) const = default;

    /// The arguments of operations that must not happen by accident.
    static constexpr quint8 key1 = 66;
    static constexpr quint8 key2 = 99;
};

/// What a look at the received bytes found.
struct Search
{
    Scan scan;
    bool passedLateAnswer = false; ///< a good frame of another sensor or operation stood before: an earlier answer

    bool operator==(const Search &) const = default;
};

/// Looks for the answer to \a request. Passed over: garbage, late answers, and the echo of the request that an adapter
/// hears of itself. An answer that mirrors its request byte by byte cannot be told from that echo and is taken for it;
/// only 99 and 220 could be answered so, and whoever sends them has to verify their effect anyway.
Search findAnswer(QByteArrayView received, const Request &request);

/// The same for Line::exchange().
ScanFunction answerTo(const Request &request);

/// The data of a whole answer without its envelope; empty for less than an envelope.
QByteArrayView dataOf(QByteArrayView answer);

} // namespace gorizont::and3
