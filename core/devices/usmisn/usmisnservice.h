#pragma once

#include "core/devices/attempts.h"
#include "core/devices/usmisn/usmisnprotocol.h"

#include <QList>

#include <functional>
#include <memory>

namespace gorizont::usmisn {

/// Everything a device says of itself.
struct Identity
{
    int address = 0;
    int type = 0; ///< inclinometerType, else another device of the series; then only the serial number below is known
    quint32 serial = 0;
    QDate program; ///< day of its program
    QDate calibratedOn;
    quint32 calibrations = 0; ///< how often it was calibrated
    QList<Channel> channels;
    bool isInclinometer() const { return type == inclinometerType; }
    bool operator==(const Identity &) const = default;
};

/// What became of a change of port settings.
struct PortChange
{
    /// Refused: impossible, or the device will not. BadReply: it still answers at the old settings. Timeout: it answers at
    /// neither; a restart makes it listen at 9600-N-1 for its first second.
    Result<void> result;
    bool isProbed = false; ///< false: this line cannot be switched over, so nobody asked at the new settings
};

/// One more record; false: stop, what is still sent is thrown away.
using TakeRecord = std::function<bool(const Value &record)>;

/// The service of УСМ-ИСН: what the dialog and gorizont-tool have in common. Every call is a bounded number of exchanges but
/// records(), which lasts as long as the device sends; a lost or damaged answer is asked for again, up to three times in all.
/// Copies share their transactions. Thread of the line.
class Service
{
public:
    explicit Service(const Timing &timing);

    /// The type of the device. Timeout: nobody is there. One exchange; repeated only after a damaged answer.
    Result<int> probe(Line &line, int address) const;
    Result<Identity> read(Line &line, int address) const;
    Result<quint32> serial(Line &line, int address) const;

    /// The address of the device with this serial number, wherever it is; up to 3 s when it is not there (Timeout).
    Result<int> find(Line &line, quint32 serial) const;
    /// The address of the only device on the line; several answer at once, which is noise (Timeout).
    Result<int> ownAddress(Line &line) const;

    /// Measures now, about 1.5 s. \a timestamp: seconds since 1970, stored with it; 0: nothing is stored. A lost answer is not
    /// asked for again when it is to be stored, because that would store a second one.
    Result<Value> measure(Line &line, int address, int channel, qint64 timestamp = 0) const;

    /// Refused: \a newAddress is taken (it is probed before), or the device will not. Timeout: it answers at neither.
    /// BadReply: still at the old one.
    Result<void> changeAddress(Line &line, int address, int newAddress) const;

    /// Sends the new settings, then asks at them and switches the line back.
    PortChange changePort(Line &line, int address, const PortSettings &wanted) const;
    /// The same for those of the factory, 9600-N-1.
    PortChange resetPort(Line &line, int address) const;

    /// From now on the device sleeps and measures. Refused: something is out of range, nothing was sent, or it will not.
    Result<void> startCycle(Line &line, int address, const Recording &recording) const;
    /// One attempt of repeatStop to wake a recorder; it listens one second in 26 (by another place of the manual in 60), so
    /// it has to be made again and again for stopLimit. Timeout: not yet.
    Result<void> tryStopCycle(Line &line, int address) const;
    static constexpr std::chrono::milliseconds repeatStop{500};
    static constexpr std::chrono::minutes stopLimit{2};

    /// Hands over the records of \a channel as they arrive. \a count: of the last ones, 0: all. Timeout: it broke off;
    /// BadReply: some could not be read; both: ask again with All, because New does not send a record twice. Cancelled: \a take
    /// wanted no more. Holds the line, up to some minutes at 9600.
    Result<void> records(
        Line &line, int address, int count, RecordMask mask, int channel, const TakeRecord &take) const;

    /// To every device of the line; none of them answers.
    Result<void> setEveryAddress(Line &line, int newAddress) const;
    Result<void> setEveryPort(Line &line, const PortSettings &wanted) const;
    Result<void> resetEveryPort(Line &line) const;
    Result<void> startEveryCycle(Line &line, const Recording &recording) const;
    Result<void> stopEveryCycle(Line &line) const; ///< to be repeated like tryStopCycle()

private:
    Asking to(int address) const { return {address, m_transactions->next()}; }
    Exchange exchangeOf(const Ask &ask, std::chrono::milliseconds patience) const;
    Result<QByteArray> exchange(Line &line, const Ask &ask, std::chrono::milliseconds patience) const;
    Result<QByteArray> exchange(Line &line, const Ask &ask) const;
    Result<void> send(Line &line, const std::optional<Ask> &ask) const;
    Result<void> echoed(Line &line, const std::optional<Ask> &ask) const;
    Result<int> askType(Line &line, int address) const;
    template <typename T>
    Result<T> ask(
        Line &line, int address, Instruction instruction, Result<T> (*decode)(QByteArrayView, const Question &)) const;
    Result<QList<Channel>> channels(Line &line, int address) const;
    Result<void> isAt(Line &line, int address) const;
    Result<int> owner(Line &line, const std::optional<Ask> &ask, std::chrono::milliseconds patience) const;
    PortChange movePort(Line &line, int address, const PortSettings &wanted, const std::optional<Ask> &ask) const;

    Timing m_timing;
    std::shared_ptr<Transactions> m_transactions;
};

} // namespace gorizont::usmisn
