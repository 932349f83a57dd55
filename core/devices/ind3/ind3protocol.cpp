#include "core/devices/ind3/ind3protocol.h"

#include "core/protocol/bytes.h"

namespace gorizont::ind3 {

namespace {

std::optional<Request> makeRequest(Packet packet, int address, const std::optional<QByteArray> &data, int answerAddress)
{
    if (!data || !isAddress(address) || !isAddress(answerAddress)) {
        return std::nullopt;
    }
    return Request{encodeFrame({packet, address, *data}), [packet, answerAddress](QByteArrayView bytes) {
                       return scanAnswer(bytes, packet, answerAddress);
                   }};
}

std::optional<Request> setCode(Packet packet, int address, std::optional<int> code)
{
    const auto data = code ? std::optional(QByteArray(1, static_cast<char>(*code))) : std::nullopt;
    return makeRequest(packet, address, data, address);
}

Result<QByteArray> answerData(QByteArrayView answer, Packet packet)
{
    const auto frame = decodeFrame(answer);
    if (!frame || !isAnswer(*frame, packet, frame->address)) {
        return Fault::BadReply;
    }
    return frame->packet == packet ? Result(frame->data) : Result<QByteArray>(Fault::Refused);
}

/// One byte of code, translated by \a valueOfCode.
template <typename T> Result<T> decodeCode(QByteArrayView answer, Packet packet, std::optional<T> (*valueOfCode)(int))
{
    const auto data = answerData(answer, packet);
    if (!data) {
        return data.fault();
    }
    const auto value = valueOfCode(byteAt(*data, 0));
    return value ? Result<T>(*value) : Result<T>(Fault::BadReply);
}

Result<Tilt> decodeTilt(QByteArrayView answer, Packet packet)
{
    const auto data = answerData(answer, packet);
    if (!data) {
        return data.fault();
    }
    const auto tilt = decodeAngleBlock(*data);
    return tilt ? Result(*tilt) : Result<Tilt>(Fault::BadReply);
}

template <typename T> Result<T> decodeNumber(QByteArrayView answer, Packet packet)
{
    const auto data = answerData(answer, packet);
    if (!data) {
        return data.fault();
    }
    const auto number = readLittle<T>(*data, 0);
    return number ? Result<T>(*number) : Result<T>(Fault::BadReply);
}

} // namespace

std::optional<Request> ask(Packet packet, int address)
{
    return isQuestion(packet) ? makeRequest(packet, address, QByteArray(), address) : std::nullopt;
}

std::optional<Request> setBaud(int address, int baud)
{
    return setCode(Packet::SetBaud, address, codeOfBaud(baud));
}

std::optional<Request> setName(int address, const QString &name)
{
    return makeRequest(Packet::SetName, address, encodeName(name), address);
}

std::optional<Request> setOffset(int address, const Tilt &offset)
{
    return makeRequest(Packet::SetOffset, address, encodeAngleBlock(offset), address);
}

std::optional<Request> setAddress(int address, int newAddress)
{
    return makeRequest(Packet::SetAddress, address, QByteArray(1, static_cast<char>(newAddress)), newAddress);
}

std::optional<Request> setTicks(int address, int ticks)
{
    return setCode(Packet::SetTicks, address, codeOfTicks(ticks));
}

std::optional<Request> setPeriod(int address, std::chrono::milliseconds period)
{
    return setCode(Packet::SetPeriod, address, codeOfPeriod(period));
}

Result<Tilt> decodeAngles(QByteArrayView answer)
{
    return decodeTilt(answer, Packet::ReadAngles);
}

Result<QString> decodeVersion(QByteArrayView answer)
{
    const auto data = answerData(answer, Packet::Version);
    return data ? Result(QString::fromLatin1(*data)) : Result<QString>(data.fault());
}

std::optional<SelfTest> decodeSelfTest(QByteArrayView answer)
{
    const auto data = answerData(answer, Packet::Error);
    if (!data || byteAt(*data, 0) < 0x10 || byteAt(*data, 0) > 0x12) {
        return std::nullopt;
    }
    return static_cast<SelfTest>(byteAt(*data, 0));
}

Result<int> decodeBaud(QByteArrayView answer)
{
    return decodeCode<int>(answer, Packet::GetBaud, baudOfCode);
}

Result<QString> decodeNameAnswer(QByteArrayView answer)
{
    const auto data = answerData(answer, Packet::GetName);
    return data ? Result(decodeName(*data)) : Result<QString>(data.fault());
}

Result<Tilt> decodeOffset(QByteArrayView answer)
{
    return decodeTilt(answer, Packet::GetOffset);
}

Result<Revision> decodeRevision(QByteArrayView answer)
{
    const auto number = decodeNumber<quint16>(answer, Packet::Revision);
    return number ? Result(Revision{*number}) : Result<Revision>(number.fault());
}

Result<quint32> decodeSerialNumber(QByteArrayView answer)
{
    return decodeNumber<quint32>(answer, Packet::SerialNumber);
}

Result<int> decodeTicks(QByteArrayView answer)
{
    return decodeCode<int>(answer, Packet::GetTicks, ticksOfCode);
}

Result<std::chrono::milliseconds> decodePeriod(QByteArrayView answer)
{
    return decodeCode<std::chrono::milliseconds>(answer, Packet::GetPeriod, periodOfCode);
}

} // namespace gorizont::ind3
