#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>
#include <QByteArrayList>

#include <optional>

/// Messages of the УСМ series. Manual 002, section 3; spec/usm-isn.md, 1 and 2.
///
///     %/ Q /AAA/TTT/Command/ data /%           request; nothing follows it
///     <LF> %/ R /AAA/TTT/Command/ data /% <CR><LF>      answer; a list of data has commas between them
///
///     AAA      address, decimal, 0…255 in one to three digits; 0 is everybody
///     TTT      transaction: any text, comes back as it was sent
///     Command  one of Instruction
///     data     may be empty, then the message ends with `//%`
///
/// A message begins at `%/` and ends at `/%`; the answer to GetInfo is printed without that slash, so `%` before CR ends one
/// too. There is no check sum. Another `%/` gives up an unfinished message. More than 2048 characters are no message
/// (section 4).
namespace gorizont::usmisn {

enum class Instruction : quint8 {
    GetSerial,
    GetType,
    GetProgVersion,
    GetDateCalibration,
    GetCountCalibration,
    GetInfo,
    GetAddress,
    SetAddress,
    SetPortSettings,
    ResetPortSettings,
    GetValue,
    GetRecord,
    StartCycle,
    StopCycle,
    GetCrc,
};

constexpr int everybody = 0; ///< the address of a broadcast
constexpr qsizetype longestMessage = 2048; ///< characters

/// As the manual spells it: `GetCRC`.
QByteArray nameOf(Instruction instruction);

/// What has to come back in an answer.
struct Question
{
    int address = 0; ///< 0…255
    QByteArray transaction;
    Instruction instruction = Instruction::GetSerial;
    bool operator==(const Question &) const = default;
};

/// The request for \a question. A broadcast has the address `0` or `000`, as the manual prints it for the instruction.
QByteArray encodeRequest(const Question &question, const QByteArray &data = {});

/// An answer without its envelope.
struct Answer
{
    int address = 0; ///< 0…255; that of the device, or 0 as in the request
    QByteArrayList fields; ///< without blanks in front; one empty field: no data
};

/// Empty: \a message, from its first `%` to its last, is not an answer to \a question. Every address may answer a
/// broadcast.
std::optional<Answer> decodeAnswer(QByteArrayView message, const Question &question);

/// Finds the answer to \a question; late answers of others, echoes and noise are passed over.
Scan scanAnswer(QByteArrayView bytes, const Question &question);

/// What GetCRC tells of \a message: CRC-32 (reflected, init and final XOR all ones) from its first `%` to its last.
quint32 crcOf(QByteArrayView message);

/// The transactions of one speaker: `001`, `002`, …, each again only after all the others.
class Transactions
{
public:
    static constexpr int most = 999;

    explicit Transactions(int first = 1, int last = most)
        : m_first(first)
        , m_last(last)
        , m_next(first)
    {
    }

    QByteArray next();

private:
    int m_first;
    int m_last;
    int m_next;
};

} // namespace gorizont::usmisn
