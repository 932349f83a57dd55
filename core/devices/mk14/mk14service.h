#pragma once

#include "core/devices/mk14/mk14options.h"
#include "core/line/line.h"
#include "core/values/weather.h"

#include <functional>

namespace gorizont::mk14 {

/// The service of a weather station: what the window and gorizont-tool have in common. Every call is a bounded number of
/// exchanges. Thread of the line. Copies are alike.
class Service
{
public:
    using Clock = std::function<UtcTime()>;

    /// \a options: Options::from() the sensor; its parameters name the values, its isClockUtc says what the clock shows.
    Service(const Options &options, const Timing &timing, Clock now = utcNow);

    /// Asks with the data command \a command, 1…8; what it does not bring is empty in the parameters. No parameters: the station has
    /// no data. The outputs stay as they are. A lost or damaged answer is asked for again, up to three times in all.
    /// Refused: address or command is out of range, nothing was sent.
    Result<Weather> read(Line &line, int address, int command) const;

    /// The control word that polling repeats: the one that setOutputs() has set on \a line, else `Outputs` of the sensor.
    quint32 outputs(const Line &line, int address) const;

    /// Gives the outputs the control word \a word, and lets every later poll on \a line repeat it until the program ends; to keep it
    /// longer, `Outputs{i}` of the ini has to say the same. The answer's digital inputs and means. Timeout, Checksum: not confirmed; polling
    /// goes on with the word before. Up to three times.
    Result<Weather> setOutputs(Line &line, int address, quint32 word) const;

    /// Sets the clock of the station to that of this computer, local time unless isClockUtc. What was sent: seconds since 1970 as the
    /// station counts them. Timeout, Checksum: not confirmed. Up to three times.
    Result<qint64> setTime(Line &line, int address) const;

    /// Sends a settings file: name 1…255 bytes, text at most 64 KiB, both as the station shall get them. Once. Timeout, Checksum:
    /// not confirmed, it may have it or not. Refused: name or text is too long, or the name is empty; nothing was sent.
    /// Takes as long as the line needs, a minute for 64 KiB at 9600 baud.
    Result<void> sendFile(Line &line, int address, const QByteArray &name, const QByteArray &text) const;

private:
    Result<Weather> asked(Line &line, int address, int command, quint32 word) const;

    Options m_options;
    Timing m_timing;
    Clock m_now;
};

} // namespace gorizont::mk14
