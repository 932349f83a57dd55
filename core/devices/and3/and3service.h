#pragma once

#include "core/devices/and3/and3answers.h"
#include "core/line/line.h"

namespace gorizont::and3 {

/// What the service of a sensor shows (manual 000, sections 9.6 – 9.10).
struct Settings
{
    int address = 0;
    std::optional<Firmware> firmware; ///< empty: the firmware does not tell
    Configuration configuration{}; ///< the current one
    ComplexRead values;
    bool operator==(const Settings &) const = default;
};

/// Where a change of address stopped. The order is that of spec/and3.md, "Address change".
enum class AddressStep : quint8 { Probe, Copy, Check, Set, Verify, Store, VerifyStored, Done };

struct AddressChange
{
    AddressStep step = AddressStep::Probe; ///< Done, or the step that failed
    /// Refused: the new address is taken. BadReply: the configuration is not as expected; before Store nothing was stored,
    /// in VerifyStored the non-volatile memory does not hold what was to be stored.
    Result<void> result;
};

/// The service of АН-Д3: what the dialog and gorizont-tool have in common. Every call is a bounded number of exchanges; a
/// lost or damaged answer is asked for again, up to three times in all. Thread of the line.
class Service
{
public:
    explicit Service(const Timing &timing);

    /// Timeout: nobody answers. One exchange; repeated only after a damaged answer.
    Result<void> probe(Line &line, int address) const;
    Result<Settings> read(Line &line, int address) const;
    Result<ComplexRead> readValues(Line &line, int address) const;

    /// Writes \a newAddress to the non-volatile memory; it holds after reset(). The inner transducer's address is left alone.
    AddressChange storeAddress(Line &line, int address, int newAddress) const;
    /// The controller restarts after a second; it answers again about five seconds later. Its answer may be missing, so only
    /// the next probe() tells whether it did. Timeout: nobody was there before, nothing was sent.
    Result<void> reset(Line &line, int address) const;

    static constexpr std::chrono::seconds restartTime{5};

private:
    Result<QByteArray> exchange(Line &line, const Request &request) const;
    Result<void> tell(Line &line, const Request &request) const;
    Result<ComplexRead> askValues(Line &line, int address) const;
    Result<Configuration> askConfiguration(Line &line, quint8 address, ConfigurationKind kind) const;
    Result<void> isHeld(Line &line, quint8 address, ConfigurationKind kind, const Configuration &expected) const;
    Result<Configuration> checkedCopy(Line &line, quint8 address) const;
    AddressChange store(Line &line, quint8 address, const Configuration &wanted, int unanswered) const;

    Timing m_timing;
};

} // namespace gorizont::and3
