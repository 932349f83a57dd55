#pragma once

#include "core/devices/lvims/lvimscapture.h"

namespace gorizont::lvims {

/// The service of an L-VIMS: what the window and gorizont-tool have in common. Every call is a bounded number of exchanges; a
/// lost answer is asked for again, up to three times in all. Thread of the line.
class Service
{
public:
    Service(const Address &address, const Timing &timing);

    Result<Identity> identity(Line &line);
    /// All channels and relays. \a fullScale: the code of 100 %, empty: it is not known.
    Result<Vibration> state(Line &line, std::optional<double> fullScale = {});
    /// CUR_SETTINGS or MUT_SETTINGS, settingsSize registers in about 60 exchanges.
    Result<Words> settings(Line &line, const Register &set);

    /// Writes all of \a values to MUT_SETTINGS, looks for errors, and lets the module use them; with \a toFlash also after its next
    /// start. Refused: it will not, errors() says why. Changes the module, its network address too: only when the user said so.
    Result<void> restoreSettings(Line &line, const QList<quint16> &values, bool toFlash);
    /// LAST_WR_ERROR and LAST_CHECK_SETTINGS_ERR after the last restoreSettings(); 0: none.
    std::pair<quint16, quint32> errors() const { return m_errors; }

    /// A capture to be stepped until it is done.
    Capture capture(Capture::Kind kind, int channel) const { return {m_link, kind, channel}; }
    /// The same at once: holds the line until it is done.
    Result<Capture> captureWhole(Line &line, Capture::Kind kind, int channel) const;

private:
    Result<Words> read(Line &line, const Range &range);
    Result<void> command(Line &line, quint32 word);
    Result<void> checkErrors(Line &line);

    Link m_link;
    std::pair<quint16, quint32> m_errors{0, 0};
};

} // namespace gorizont::lvims
