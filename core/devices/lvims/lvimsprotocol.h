#pragma once

#include "core/devices/lvims/lvimswords.h"
#include "core/values/vibration.h"

/// What the registers of an L-VIMS mean: manual 003, sections 2.2, 2.3, 4 and 5; spec/l-vims.md.
namespace gorizont::lvims {

/// The first and the number of the registers that are read together.
struct Range
{
    quint16 first = 0;
    int count = 0;

    constexpr static Range from(const Register &first, const Register &last, int channel = 0)
    {
        return {first.at(channel), last.at(channel) + last.size - first.at(channel)};
    }
};

/// What the module is, and what it thought of what was last written.
struct Identity
{
    QString name; ///< VIMS_ICP
    QString serial;
    QString firmware;
    QString board;
    int mode = 0; ///< bootLoaderMode, workingMode
    quint16 writeError = 0; ///< 0: none
    quint32 settingsError = 0; ///< 0: none
    bool operator==(const Identity &) const = default;
};

constexpr int bootLoaderMode = 1;
constexpr int workingMode = 2;
constexpr Range identityRange = Range::from(moduleRegister("DEVNAME"), moduleRegister("LAST_CHECK_SETTINGS_ERR"));
constexpr Range modeRange{moduleRegister("DEVMODE").address, 1};

Identity identityOf(const Words &words);

/// What has changed in the module: section 3. One read.
struct Status
{
    struct Channel
    {
        quint16 state = 0; ///< ID of the last update
        quint16 waveform = 0;
        quint16 waveformsReady = 0; ///< 0: one is being captured
        quint16 spectrum5000 = 0;
        quint16 spectra5000Ready = 0;
        quint16 spectrum200 = 0;
        quint16 spectra200Ready = 0;
        bool operator==(const Channel &) const = default;
    };

    std::array<Channel, channelCount> channels;
    quint16 settings = 0;
    quint16 relays = 0;
    bool operator==(const Status &) const = default;
};

constexpr Range statusRange = Range::from(moduleRegister("ST_CH_UP_ID"), moduleRegister("OUTSYS_UP_ID"));

Status statusOf(const Words &words);

constexpr Range channelRange(int channel)
{
    return {moduleRegister("CH_STATE").at(channel), channelStateSize};
}
constexpr Range relayRange{moduleRegister("RELE_STATE").address, moduleRegister("RELE_STATE").size};

/// CHST. \a chst: counted from its first register. \a fullScale: the code of 100 %, empty: it is not known.
VibrationChannel channelOf(const Words &chst, int channel, std::optional<double> fullScale);

QList<Relay> relaysOf(quint32 state);

} // namespace gorizont::lvims
