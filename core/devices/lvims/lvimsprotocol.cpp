#include "core/devices/lvims/lvimsprotocol.h"

#include <cmath>

namespace gorizont::lvims {

namespace {

/// Two bits: 00 false, 01 true, 10 Z; 11 is not described and says as little as Z.
std::optional<bool> triboolOf(quint16 flags, int bit)
{
    switch (flags >> bit & 3) {
    case 0: return false;
    case 1: return true;
    default: return std::nullopt;
    }
}

double percentOf(quint16 code, std::optional<double> fullScale)
{
    return fullScale ? code * 100 / *fullScale : code;
}

VibrationMeasurement measurementOf(const Words &chst, int index, bool isGood, std::optional<double> fullScale)
{
    constexpr int baselineValid = 1 << 8;
    constexpr int baselineExceeded = 1 << 9;
    constexpr Register value = channelRegister("MEAS_VALUE");
    const quint16 flags = chst.word(channelRegister("MEAS_ST_FLAGS"), 0, index);
    const float number = chst.real(value, 0, index);

    VibrationMeasurement measurement;
    measurement.index = index;
    measurement.type = chst.word(channelRegister("MEAS_TYPE"), 0, index);
    measurement.fault = triboolOf(flags, 0);
    measurement.warning = triboolOf(flags, 2);
    measurement.stop = triboolOf(flags, 4);
    measurement.isBaselineExceeded = flags & baselineExceeded;
    if (isGood && std::isfinite(number)) {
        measurement.value = number;
    }
    if (isGood) {
        measurement.percent = percentOf(chst.word(channelRegister("MEAS_FS_PERC"), 0, index), fullScale);
    }
    if (flags & baselineValid) {
        measurement.baseline = percentOf(chst.word(channelRegister("MEAS_BASELINE_PERC"), 0, index), fullScale);
    }
    return measurement;
}

} // namespace

Identity identityOf(const Words &words)
{
    return {
        words.text(moduleRegister("DEVNAME")),
        words.text(moduleRegister("SERIAL")),
        words.text(moduleRegister("FWVER")),
        words.text(moduleRegister("BRD_REV")),
        words.word(moduleRegister("DEVMODE")),
        words.word(moduleRegister("LAST_WR_ERROR")),
        words.doubleWord(moduleRegister("LAST_CHECK_SETTINGS_ERR"))};
}

Status statusOf(const Words &words)
{
    Status status;
    for (int i = 0; i < channelCount; ++i) {
        status.channels[static_cast<std::size_t>(i)] = {words.word(moduleRegister("ST_CH_UP_ID"), i),
                                                        words.word(moduleRegister("ST_WF_UP_ID"), i),
                                                        words.word(moduleRegister("ST_WF_RDY_CNT"), i),
                                                        words.word(moduleRegister("ST_SPEC_5000_UP_ID"), i),
                                                        words.word(moduleRegister("ST_SPEC_5000_RDY_CNT"), i),
                                                        words.word(moduleRegister("ST_SPEC_200_UP_ID"), i),
                                                        words.word(moduleRegister("ST_SPEC_200_RDY_CNT"), i)};
    }
    status.settings = words.word(moduleRegister("ST_SET_UP_ID"));
    status.relays = words.word(moduleRegister("OUTSYS_UP_ID"));
    return status;
}

VibrationChannel channelOf(const Words &chst, int channel, std::optional<double> fullScale)
{
    VibrationChannel result;
    result.channel = channel;
    result.state = static_cast<ChannelState>(chst.word(channelRegister("CH_STATUS")));
    for (int i = 0; i < measurementCount; ++i) {
        if (chst.word(channelRegister("MEAS_TYPE"), 0, i) != 0) {
            result.measurements.append(measurementOf(chst, i, result.state == ChannelState::Good, fullScale));
        }
    }
    return result;
}

QList<Relay> relaysOf(quint32 state)
{
    QList<Relay> relays;
    for (int i = 0; i < relayCount; ++i) {
        const auto bit = [&](int group) { return (state >> (8 * group + i) & 1) != 0; };
        relays.append({i, bit(0), bit(1), bit(2), bit(3)});
    }
    return relays;
}

} // namespace gorizont::lvims
