#pragma once

#include <QList>

#include <optional>

namespace gorizont {

/// What a vibration module says of the line to one of its sensors; other numbers may come.
enum class ChannelState : quint16 {
    Good = 0,
    ShortCircuit = 1,
    Break = 2,
    NoData = 0xFFFF, ///< nothing measured yet
};

/// One measurement of a channel. Flags: empty: the module does not know.
struct VibrationMeasurement
{
    int index = 0; ///< M, 0…7
    int type = 0; ///< MEAS_TYPE of manual 003, 1…16
    std::optional<double> value; ///< in the unit of the type; empty: not valid
    std::optional<double>
        percent; ///< of the user's scale, or the raw code when that scale is not known; empty: not valid
    std::optional<bool> fault;
    std::optional<bool> warning;
    std::optional<bool> stop;
    std::optional<double> baseline; ///< as percent; empty: there is none
    bool isBaselineExceeded = false;
    bool operator==(const VibrationMeasurement &) const = default;

    bool isRaised() const { return fault.value_or(false) || warning.value_or(false) || stop.value_or(false); }
};

struct VibrationChannel
{
    int channel = 0; ///< I, 0…3
    ChannelState state = ChannelState::NoData;
    bool isEnabled = true; ///< by the settings of the module
    QList<VibrationMeasurement> measurements; ///< those in use, ascending by index
    bool operator==(const VibrationChannel &) const = default;

    /// Fault, warning or stop of a measurement.
    bool isAnythingRaised() const
    {
        for (const VibrationMeasurement &measurement : measurements) {
            if (isEnabled && measurement.isRaised()) {
                return true;
            }
        }
        return false;
    }

    /// The channel is in use, and the line to its sensor is shorted or broken.
    bool hasLineFault() const
    {
        return isEnabled && (state == ChannelState::ShortCircuit || state == ChannelState::Break);
    }
};

/// One of the outputs of a vibration module.
struct Relay
{
    int index = 0; ///< R, 0…7
    bool isLogical = false;
    bool isPhysical = false;
    bool hasError = false;
    bool isEnabled = false;
    bool operator==(const Relay &) const = default;
};

/// What a vibration module measures. Copies share their lists.
struct Vibration
{
    QList<VibrationChannel> channels; ///< ascending
    QList<Relay> relays; ///< ascending
    bool operator==(const Vibration &) const = default;

    /// Every channel in use has a fault of its line, and there is at least one.
    bool isWithoutSensors() const
    {
        int enabled = 0;
        int faulty = 0;
        for (const VibrationChannel &channel : channels) {
            enabled += channel.isEnabled ? 1 : 0;
            faulty += channel.hasLineFault() ? 1 : 0;
        }
        return enabled > 0 && faulty == enabled;
    }
};

} // namespace gorizont
