#pragma once

#include "core/protocol/ackframe.h"
#include "core/protocol/request.h"
#include "core/values/result.h"
#include "core/values/weather.h"

#include <QList>

/// What a dispatcher asks a weather station and what it says (manual 004, sections 3.6 and 4.2; spec/mk14.md, "Frames").
namespace gorizont::ack {

constexpr int firstDataCommand = 1;
constexpr int lastDataCommand = 8;
constexpr int extraFloats = 3; ///< behind the parameters of CMD 8: σ of the direction, σ and maximum of the speed
constexpr int extraTimes = 10; ///< then: begin (> 0) and end (< 0) of precipitation, newest first; 0: none
constexpr int mostParameters = 255; ///< LEN is a byte; CMD 8 with LEN that counts its extras: 242
constexpr qsizetype longestName = 255; ///< of a file, bytes
constexpr quint32 longestFile = 64 * 1024; ///< bytes; "small files": a limit of ours

/// The values of one parameter in the order in which \a command sends them; every one empty when it is not valid (FF FF FF FF).
using Values = QList<std::optional<float>>;

/// How many values a parameter has in the answer to \a command, 1…8: 1, 2, 3, 4, 5, 6, 3, 1; 0: no data command.
int valuesPerParameter(int command);

/// What the values of a parameter are, in the order in which \a command, 1…8, sends them (manual 004, section 4.2).
QList<std::optional<double> WeatherParameter::*> membersOf(int command);

/// A data command: who is asked for what. An answer does not repeat the command, so the question is remembered.
struct Question
{
    quint8 address = 1; ///< 1…255
    quint8 command = 1; ///< 1…8
    int parameters = 0; ///< how many the station has; 0: not known. Tells the two readings of LEN in CMD 8 apart
    bool operator==(const Question &) const = default;
};

/// The content of an answer to a data command.
struct Answer
{
    quint32 digital = 0; ///< the digital inputs
    QList<Values> parameters; ///< empty: the station has no data
    Values extras; ///< of CMD 8: σ of the direction, σ of the speed, maximum of the speed; else empty
    QList<qint32> precipitation; ///< of CMD 8: seconds since 1970, up to the first 0
    bool operator==(const Answer &) const = default;
};

// The dispatcher's side

/// \a outputs: the control word of the station's outputs, sent with every question (spec/mk14.md, 2).
Request ask(const Question &question, quint32 outputs);
/// Sets the clock of a station.
Request askTime(quint8 address, quint32 secondsSince1970);
/// Sends a settings file; empty when the name is not 1…255 bytes or the text is over 64 KiB.
std::optional<Request> askFile(quint8 address, const QByteArray &name, const QByteArray &text);

/// BadReply: not an answer to \a question.
Result<Answer> decodeAnswer(QByteArrayView frame, const Question &question);

// The station's side

/// A request that a station heard.
struct Asked
{
    quint8 address = 1;
    quint8 command = 0;
    quint32 digital = 0; ///< control word; seconds since 1970 when the clock is set
    QByteArray fileName; ///< of a file; empty: none
    QByteArray file;

    bool isTime() const { return command == transferCommand && fileName.isEmpty(); }
    bool isFile() const { return command == transferCommand && !fileName.isEmpty(); }
    bool operator==(const Asked &) const = default;
};

/// Looks for a request to \a address among all that is said on a line.
Scan scanRequest(QByteArrayView bytes, quint8 address);
/// BadReply: not a request.
Result<Asked> decodeRequest(QByteArrayView frame);

/// The answer of the station at \a address to the data command \a command. Each of answer.parameters holds
/// valuesPerParameter(command) values; extras and precipitation count for CMD 8 only and are filled up to 3 and 10.
QByteArray encodeAnswer(quint8 address, int command, const Answer &answer);
/// The bare header that confirms a file, the clock, or says that there are no data.
QByteArray encodeConfirmation(quint8 address, quint32 digital);

} // namespace gorizont::ack
