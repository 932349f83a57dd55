#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>

#include <optional>

/// Protocol 2.11 of ИН-Д2/3/7/9. «Обмен данными с измерителем угла наклона версии 2.xx», document version 1.2;
/// spec/ind3.md, section "Protocol 2.11".
///
///     7E PP KK AA data… SS 7E        request and answer alike
///
///     PP   protocol: 9B main, 9C additional
///     KK   packet
///     AA   address 1…255; the answer to SetAddress carries the new one
///     SS   XOR of PP, KK, AA and every data byte, before escaping
///
/// Between the delimiters 7D and 7E travel as 7D followed by the byte XOR 20, SS included. Two frames may share a
/// delimiter, and `7E 7E` is legal. Numbers of several bytes are little-endian.
namespace gorizont::ind3 {

/// PP and KK; after them the data of the request, then of the answer.
enum class Packet : quint16 {
    ReadAngles = 0x9B01, ///< – / 6 bytes, the angle block
    Version = 0x9B0E, ///< – / 5 ASCII, `v2.11`
    Error = 0x9BFF, ///< only as the answer to Version: 1 byte, SelfTest
    GetBaud = 0x9C01, ///< – / 1 byte, code
    SetBaud = 0x9C02, ///< code / –, answered at the old speed
    GetName = 0x9C03, ///< – / 1…16 bytes, Windows-1251; `NO NAME` from the factory
    SetName = 0x9C04, ///< 1…16 bytes / –
    GetOffset = 0x9C05, ///< – / 6 bytes, the angle block. Old firmware does not answer
    SetOffset = 0x9C06, ///< 6 bytes / –. Old firmware does not answer
    SetAddress = 0x9C09, ///< new address / –
    Revision = 0x9C0A, ///< – / 2 bytes
    SerialNumber = 0x9C0B, ///< – / 4 bytes
    GetTicks = 0x9C0C, ///< – / 1 byte, code
    SetTicks = 0x9C0D, ///< code / –
    GetPeriod = 0x9C0E, ///< – / 1 byte, code
    SetPeriod = 0x9C0F, ///< code / –
};

/// A frame without its envelope.
struct Frame
{
    Packet packet = Packet::Error;
    int address = 0;
    QByteArray data;
    bool operator==(const Frame &) const = default;
};

QByteArray encodeFrame(const Frame &frame);

/// Empty: not one whole frame with a good check sum, delimiters included.
std::optional<Frame> decodeFrame(QByteArrayView bytes);

/// Whether \a frame has the packet, the address and the amount of data of an answer to \a asked. To Version the answer may
/// be Error.
bool isAnswer(const Frame &frame, Packet asked, int address);

/// Finds the answer that \a address gives to \a asked.
Scan scanAnswer(QByteArrayView bytes, Packet asked, int address);

/// What \a packet is answered with has data: it reads, it does not set.
bool isQuestion(Packet packet);

} // namespace gorizont::ind3
