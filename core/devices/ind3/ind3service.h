#pragma once

#include "core/devices/attempts.h"
#include "core/devices/ind3/ind3dialect.h"
#include "core/devices/ind3/ind3protocol.h"
#include "core/devices/ind3/ind3values.h"
#include "core/line/line.h"

namespace gorizont::ind3 {

/// Everything that the service of a sensor shows (manual 000, section 8.7).
struct Settings
{
    int address = 0;
    QString version; ///< `v2.11`; empty in Modbus, which has none, and with a self-test that failed
    Revision revision;
    quint32 serialNumber = 0;
    int baud = 0; ///< baud
    std::optional<QString> name; ///< empty: Modbus, which has none
    std::optional<Tilt> offset; ///< arc-seconds; empty: old firmware does not answer
    int ticks = 0; ///< 1…64
    std::chrono::milliseconds period{0}; ///< 10, 20, 50, 100 ms
    std::optional<SelfTest> selfTest; ///< what the sensor found wrong with itself instead of telling its version
    bool operator==(const Settings &) const = default;
};

/// What is to be written; what is empty stays as it is.
struct Changes
{
    std::optional<QString> name; ///< 1…16 characters of Windows-1251
    std::optional<Tilt> offset; ///< arc-seconds
    std::optional<int> ticks;
    std::optional<std::chrono::milliseconds> period;
    bool isEmpty() const { return *this == Changes(); }
    bool operator==(const Changes &) const = default;
};

enum class Setting : quint8 { Name, Offset, Ticks, Period };

/// What became of one setting: written and read back; Refused: out of range, nothing was sent, or the sensor will not;
/// BadReply: the sensor answered, but the value read back is another one; else the fault of the last attempt.
struct Outcome
{
    Setting setting;
    Result<void> written;
};

/// The service of ИН-Д3 in protocol 2.11 or Modbus RTU: what the dialog and gorizont-tool have in common. Every call is
/// a bounded number of exchanges; a lost or damaged answer is asked for again, up to three times in all. Thread of the line.
class Service
{
public:
    /// V210 has no settings: every call answers Refused except probe() and readTilt().
    Service(const Timing &timing, Dialect dialect);

    /// Whether a sensor answers at \a address: Timeout: nobody. One exchange; repeated only after a damaged answer.
    Result<void> probe(Line &line, int address) const;
    Result<Settings> read(Line &line, int address) const;
    Result<Tilt> readTilt(Line &line, int address) const; ///< arc-seconds, as the sensor has it

    /// Writes what is there, in the order of Setting, reads each back; goes on after a setting that failed, but not after a
    /// fault of the line.
    QList<Outcome> write(Line &line, int address, const Changes &changes) const;

    /// Refused: \a newAddress is taken (it is probed before), or the sensor will not. A lost answer is no failure if the
    /// sensor then answers at its new address and not at the old one. Timeout: it answers at neither. BadReply: still at the
    /// old one.
    Result<void> changeAddress(Line &line, int address, int newAddress) const;

private:
    template <typename T> using Decode = Result<T> (*)(QByteArrayView answer);

    Result<QByteArray> exchange(Line &line, const std::optional<Request> &request) const;
    /// One question; \a decode reads its answer.
    template <typename T> Result<T> question(Line &line, const std::optional<Request> &request, Decode<T> decode) const
    {
        const auto answer = exchange(line, request);
        return answer ? decode(*answer) : Result<T>(answer.fault());
    }
    template <typename T> Result<T> ask(Line &line, const std::optional<Request> &request, Decode<T> decode) const
    {
        return withAttempts([&] { return question(line, request, decode); });
    }
    Result<Tilt> askTilt(Line &line, int address) const;
    Result<void> readVersion(Line &line, Settings &settings) const;
    Result<Settings> read211(Line &line, int address) const;
    Result<Settings> readModbus(Line &line, int address) const;
    Result<void> writeOne(Line &line, int address, const Changes &changes, Setting setting) const;
    std::optional<Request> setRequest(int address, const Changes &changes, Setting setting) const;
    Result<void> confirmed(const Result<QByteArray> &answer) const;
    Result<void> isHeld(Line &line, int address, const Changes &changes, Setting setting) const;
    Result<void> isHeldModbus(Line &line, int address, const Changes &changes, Setting setting) const;
    std::optional<Request> addressRequest(int address, int newAddress) const;
    Result<bool> answersSteadily(Line &line, int address) const;

    Timing m_timing;
    Dialect m_dialect;
};

} // namespace gorizont::ind3
