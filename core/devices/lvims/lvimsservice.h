#pragma once

#include "core/devices/lvims/lvimscapture.h"
#include "core/devices/lvims/lvimssettings.h"
#include "core/devices/lvims/lvimssettingsfile.h"
#include "core/values/sensorconfig.h"

namespace gorizont::lvims {

/// The service of an L-VIMS: what the window and gorizont-tool have in common. Every call is a bounded number of exchanges; a
/// lost answer is asked for again, up to three times in all. Thread of the line.
class Service
{
public:
    Service(const Address &address, const Timing &timing);
    /// Of the module that \a sensor is in the ini: by its options.
    static Service of(const SensorConfig &sensor, const Timing &timing);

    Result<Identity> identity(Line &line);
    /// All channels and relays. \a fullScale: the code of 100 %, empty: it is not known.
    Result<Vibration> state(Line &line, std::optional<double> fullScale = {});
    /// CUR_SETTINGS or MUT_SETTINGS, settingsSize registers in about 60 exchanges.
    Result<Words> settings(Line &line, const Register &set);

    /// Writes all of \a values to MUT_SETTINGS, looks for errors, and lets the module use them; with \a toFlash also after its next
    /// start. Refused: it will not, errors() says why. Changes the module, its network address too: only when the user said so.
    Result<void> restoreSettings(Line &line, const QList<quint16> &values, bool toFlash);
    /// Those after the last restoreSettings().
    SettingErrors errors() const { return m_errors; }

    // The same as steps of one exchange each, for those who let others speak between them.

    /// Appends to \a values what follows in CUR_SETTINGS or MUT_SETTINGS, until they are settingsSize.
    Result<void> readMore(Line &line, const Register &set, QList<quint16> &values);
    /// To MUT_SETTINGS: the module does not use it before it is told to.
    Result<void> write(Line &line, const SettingPiece &piece);
    /// LAST_WR_ERROR is that of the last write(), LAST_CHECK_SETTINGS_ERR that of the last command: until the next one it stays.
    Result<SettingErrors> readErrors(Line &line);
    /// Asked for once only: whether the module obeyed is seen in readErrors().
    Result<void> apply(Line &line); ///< MUT_SETTINGS are used from now on; with another IP address no answer may come
    Result<void> saveToFlash(Line &line);
    Result<void> loadFromFlash(Line &line); ///< and uses what it finds there
    /// A module that is gone before it has answered obeyed too.
    Result<void> restart(Line &line);

    /// A capture to be stepped until it is done.
    Capture capture(Capture::Kind kind, int channel) const { return {m_link, kind, channel}; }
    /// The same at once: holds the line until it is done.
    Result<Capture> captureWhole(Line &line, Capture::Kind kind, int channel) const;

private:
    Result<Words> read(Line &line, const Range &range);
    Result<void> tell(Line &line, quint32 word);
    Result<void> command(Line &line, quint32 word);
    Result<void> checkErrors(Line &line);

    Link m_link;
    SettingErrors m_errors{0, 0};
};

} // namespace gorizont::lvims
