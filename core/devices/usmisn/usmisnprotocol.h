#pragma once

#include "core/devices/usmisn/usmisnframe.h"
#include "core/devices/usmisn/usmisnvalues.h"
#include "core/protocol/request.h"
#include "core/values/result.h"

/// The fifteen instructions of manual 002, section 3: what is sent, and what an answer says.
namespace gorizont::usmisn {

/// A question and the data it takes along; a text is one message.
struct Ask
{
    Question question;
    QByteArray data;

    QByteArray bytes() const { return encodeRequest(question, data); }
    Request request() const;
};

/// Builds requests to one \a address, 0…255. Empty: something is out of range, the device would say ErrorData.
class Asking
{
public:
    Asking(int address, QByteArray transaction)
        : m_address(address)
        , m_transaction(std::move(transaction))
    {
    }

    /// An instruction without data: everything but the five below.
    Ask plain(Instruction instruction) const;
    std::optional<Ask> setAddress(int newAddress) const; ///< 1…255
    std::optional<Ask> setPortSettings(const PortSettings &port) const;
    /// \a channel: 1 or 2, or a whole ChannelId in a broadcast. \a timestamp: 0: not stored.
    std::optional<Ask> getValue(quint64 channel, qint64 timestamp = 0) const;
    /// \a count: how many of the last records are looked through, 0…999; 0: all.
    std::optional<Ask> getRecord(int count, RecordMask mask, quint64 channel) const;
    std::optional<Ask> startCycle(const Recording &recording) const;

private:
    Ask with(Instruction instruction, const QByteArray &data) const;

    int m_address;
    QByteArray m_transaction;
};

constexpr int mostCounted = 999; ///< of getRecord(): three digits

/// Every decode…() takes the bytes that a scan found. BadReply: not an answer to \a question, or its fields are not of the
/// form that the manual gives. Refused: ErrorData or another keyword instead of a value.
Result<quint32> decodeSerial(QByteArrayView bytes, const Question &question); ///< of the device, up to eight digits
Result<int> decodeType(QByteArrayView bytes, const Question &question); ///< 0…999; see inclinometerType
Result<QDate> decodeProgVersion(QByteArrayView bytes, const Question &question); ///< day of the program, 2000…2099
Result<QDate> decodeDateCalibration(QByteArrayView bytes, const Question &question);
Result<quint32> decodeCountCalibration(QByteArrayView bytes, const Question &question);
Result<std::optional<Channel>> decodeInfo(QByteArrayView bytes, const Question &question); ///< empty: End
Result<int> decodeAddress(QByteArrayView bytes, const Question &question); ///< GetAddress, SetAddress: 0…255
Result<Value> decodeValue(QByteArrayView bytes, const Question &question);
Result<std::optional<Value>> decodeRecord(QByteArrayView bytes, const Question &question); ///< empty: End
Result<quint32> decodeCrc(QByteArrayView bytes, const Question &question); ///< 0: nothing was sent since the start
/// The answer to an instruction that sets something repeats its data.
Result<void> decodeEcho(QByteArrayView bytes, const Ask &ask);

/// The address that the answer comes from; 0: the device repeats the broadcast.
int addressOf(QByteArrayView bytes, const Question &question);

} // namespace gorizont::usmisn
