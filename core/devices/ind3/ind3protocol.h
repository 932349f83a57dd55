#pragma once

#include "core/devices/ind3/ind3frame.h"
#include "core/devices/ind3/ind3values.h"
#include "core/protocol/request.h"
#include "core/values/result.h"

/// Questions and answers of protocol 2.11; the frame and the table of packets are in ind3frame.h. «Обмен данными с
/// измерителем угла наклона версии 2.xx», document version 1.2; spec/ind3.md, section "Protocol 2.11".
namespace gorizont::ind3 {

/// What the device found wrong with itself, in the answer Error.
enum class SelfTest : quint8 { ProgramChecksum = 0x10, SettingsChecksum = 0x11, BothChecksums = 0x12 };

/// Requests. Empty: a value is out of range, or \a packet needs data (ask).
std::optional<Request> ask(Packet packet, int address);
std::optional<Request> setBaud(int address, int baud);
std::optional<Request> setName(int address, const QString &name);
std::optional<Request> setOffset(int address, const Tilt &offset);
std::optional<Request> setAddress(int address, int newAddress);
std::optional<Request> setTicks(int address, int ticks);
std::optional<Request> setPeriod(int address, std::chrono::milliseconds period);

/// What a found answer says. BadReply: it is the answer to something else, or a code that the document does not have.
Result<Tilt> decodeAngles(QByteArrayView answer);
Result<QString> decodeVersion(QByteArrayView answer); ///< Refused: the answer is Error, see decodeSelfTest()
std::optional<SelfTest> decodeSelfTest(QByteArrayView answer);
Result<int> decodeBaud(QByteArrayView answer); ///< baud
Result<QString> decodeNameAnswer(QByteArrayView answer);
Result<Tilt> decodeOffset(QByteArrayView answer); ///< arc-seconds
Result<Revision> decodeRevision(QByteArrayView answer);
Result<quint32> decodeSerialNumber(QByteArrayView answer);
Result<int> decodeTicks(QByteArrayView answer);
Result<std::chrono::milliseconds> decodePeriod(QByteArrayView answer);

} // namespace gorizont::ind3
