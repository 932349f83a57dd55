#pragma once

#include <QtGlobal>

#include <array>
#include <stdexcept>
#include <string_view>

/// The registers of an L-VIMS as data: manual 003, sections 2.2 to 2.5. Addresses are those of the PDU, counted from 0, as
/// the manual prints them. Codec, service, simulator and document read this table and nothing else.
namespace gorizont::lvims {

enum class RegisterType : quint8 {
    U16,
    U16S, ///< code of a share of a scale
    U32, ///< low word first
    Float, ///< IEEE 754, low word first
    Text, ///< STRN: ASCII or UTF-8, low byte first, ends with 0 or with its registers
    IpAddress, ///< low byte first
    Words, ///< U16[n]
    ChannelState, ///< CHST, section 2.3
    Settings, ///< SET, section 2.4
    Filter, ///< IIR, section 2.5
};

enum class Access : quint8 { Read, Write, ReadWrite };

struct Register
{
    std::string_view name; ///< as the manual spells it
    quint16 address = 0; ///< of the first one, within its map
    RegisterType type = RegisterType::U16;
    quint16 size = 1; ///< registers
    Access access = Access::Read;
    std::string_view unit; ///< empty: none, or it depends on a setting
    std::string_view meaning;
    quint16 channelStep = 0; ///< registers from one channel (I) to the next; 0: there is one for all
    quint16 itemStep = 0; ///< registers from one measurement (M) or sample (S) to the next; 0: there is one
    quint16 items = 1; ///< how many measurements or samples

    constexpr quint16 at(int channel = 0, int item = 0) const
    {
        return static_cast<quint16>(address + channelStep * channel + itemStep * item);
    }
    bool operator==(const Register &) const = default;
};

constexpr int channelCount = 4;
constexpr int measurementCount = 8;
constexpr int relayCount = 8;
constexpr int samplesAtOnce = 62; ///< S: what can be read without the registers that are echoed
constexpr quint16 channelStateSize = 88; ///< registers of CHST
constexpr quint16 settingsSize = 7456; ///< registers of SET

// clang-format off
namespace table {

using enum RegisterType;
using enum Access;

/// Section 2.2.
inline constexpr std::array moduleRegisters{
    Register{"DEVNAME", 1, Text, 16, Read, "", "name of the device: VIMS_ICP"},
    Register{"SERIAL", 17, Text, 16, Read, "", "serial number"},
    Register{"FWVER", 33, Text, 16, Read, "", "version of the firmware"},
    Register{"BRD_REV", 49, Text, 8, Read, "", "revision of the board"},
    Register{"DEVMODE", 97, U16, 1, Read, "", "1 boot loader, 2 at work"},
    Register{"LAST_WR_ERROR", 98, U16, 1, Read, "", "error of the last write"},
    Register{"LAST_CHECK_SETTINGS_ERR", 99, U32, 2, Read, "", "error of the last write of settings"},

    Register{"ST_CH_UP_ID", 1024, U16, 1, Read, "", "counts the updates of CH_STATE", 1},
    Register{"ST_WF_UP_ID", 1028, U16, 1, Read, "", "counts the updates of the waveform", 1},
    Register{"ST_WF_RDY_CNT", 1032, U16, 1, Read, "", "waveforms kept: 0 while one is captured, then 1", 1},
    Register{"ST_SPEC_5000_UP_ID", 1036, U16, 1, Read, "", "counts the updates of the spectrum up to 5000 Hz", 1},
    Register{"ST_SPEC_5000_RDY_CNT", 1040, U16, 1, Read, "", "spectra up to 5000 Hz kept", 1},
    Register{"ST_SPEC_200_UP_ID", 1044, U16, 1, Read, "", "counts the updates of the spectrum up to 200 Hz", 1},
    Register{"ST_SPEC_200_RDY_CNT", 1048, U16, 1, Read, "", "spectra up to 200 Hz kept", 1},
    Register{"ST_SET_UP_ID", 1052, U16, 1, Read, "", "counts the updates of the settings without a restart"},
    Register{"OUTSYS_UP_ID", 1053, U16, 1, Read, "", "counts the updates of the relays"},

    Register{"CH_STATE", 1280, ChannelState, channelStateSize, Read, "", "state of a channel", channelStateSize},
    Register{"RELE_STATE", 1632, U32, 2, Read, "", "relay R: bit R logical, 8 + R physical, 16 + R error, 24 + R enabled"},

    Register{"WF_RD_CH", 36864, U16, 1, ReadWrite, "", "channel of the waveform to read"},
    Register{"WF_RD_ID", 36865, U16, 1, ReadWrite, "", "ID of the waveform to read"},
    Register{"WF_RD_OFFS", 36866, U32, 2, ReadWrite, "", "first sample to read"},
    Register{"WF_RD_DATA", 36868, U32, 2, ReadWrite, "", "code of sample S + WF_RD_OFFS", 0, 2, samplesAtOnce},

    Register{"WF_INFO_CH", 37120, U16, 1, Read, "", "channel of the waveform"},
    Register{"WF_INFO_ID", 37121, U16, 1, Read, "", "ID of the waveform"},
    Register{"WF_INFO_SIZE", 37122, U32, 2, Read, "", "samples in the waveform"},
    Register{"WF_INFO_FREQ", 37124, Float, 2, Read, "Hz", "samples a second"},
    Register{"WF_INFO_E_K", 37126, Float, 2, Read, "V", "K of code to volts, y = Kx + B"},
    Register{"WF_INFO_E_B", 37128, Float, 2, Read, "V", "B of code to volts"},
    Register{"WF_INFO_P_K", 37130, Float, 2, Read, "", "K of code to the physical quantity, y = Kx + B"},
    Register{"WF_INFO_P_B", 37132, Float, 2, Read, "", "B of code to the physical quantity"},
    Register{"WF_INFO_CHST", 37156, ChannelState, channelStateSize, Read, "", "state of the channel when the waveform was kept"},

    Register{"SPECTR_RD_CH", 37376, U16, 1, ReadWrite, "", "channel of the spectrum to read"},
    Register{"SPECTR_RD_TYPE", 37377, U16, 1, ReadWrite, "", "spectrum to read: 0 up to 5000 Hz, 1 up to 200 Hz"},
    Register{"SPECTR_RD_OFFS", 37378, U32, 2, ReadWrite, "", "first number to read"},
    Register{"SPECTR_RD_DATA", 37380, U32, 2, ReadWrite, "", "code of number S + SPECTR_RD_OFFS: even real, odd imaginary", 0, 2, samplesAtOnce},

    Register{"SPECTR_INFO_CH", 37632, U16, 1, Read, "", "channel of the spectrum"},
    Register{"SPECTR_INFO_TYPE", 37633, U16, 1, Read, "", "0 up to 5000 Hz, 1 up to 200 Hz"},
    Register{"SPECTR_INFO_SIZE", 37634, U32, 2, Read, "", "numbers in the spectrum, real and imaginary"},
    Register{"SPECTR_INFO_DECI_FREQ", 37636, Float, 2, Read, "Hz", "samples a second that the spectrum was made of"},
    Register{"SPECTR_INFO_E_K", 37638, Float, 2, Read, "V", "K of code to volts, y = Kx + B"},
    Register{"SPECTR_INFO_E_B", 37640, Float, 2, Read, "V", "B of code to volts"},
    Register{"SPECTR_INFO_P_K", 37642, Float, 2, Read, "", "K of code to the physical quantity, y = Kx + B"},
    Register{"SPECTR_INFO_P_B", 37644, Float, 2, Read, "", "B of code to the physical quantity"},
    Register{"SPECTR_INFO_WND_SUM", 37646, Float, 2, Read, "", "sum of the coefficients of the window"},
    Register{"SPECTR_INFO_WND_SUM2", 37648, Float, 2, Read, "", "sum of their squares"},

    Register{"CMD_INPUT", 40960, U16, 1, Write, "", "5649h keep the next waveform, 5651h keep the spectra of now"},
    Register{"CUR_SETTINGS", 45056, Settings, settingsSize, Read, "", "settings in use"},
    Register{"MUT_SETTINGS", 53248, Settings, settingsSize, ReadWrite, "", "settings to be applied or kept"},
    Register{"SETTINGS_CMD", 61440, U32, 2, Write, "", "56494253h to flash, 564942AAh from flash and in use, 564942CCh in use"},
    Register{"REBOOT_CMD", 65280, Words, 4, Write, "", "424Fh 4F53h 5245h 5354h restart the module"},
};

/// Section 2.3: CHST, counted from its first register.
inline constexpr std::array channelRegisters{
    Register{"CH_STATUS", 0, U16, 1, Read, "", "FFFFh no data, 0 good, 1 short circuit, 2 break of the sensor's line"},
    Register{"MEAS_TYPE", 8, U16, 1, Read, "", "type of measurement M, 0 not used", 0, 10, measurementCount},
    Register{"MEAS_ST_FLAGS", 9, U16, 1, Read, "", "bits 0, 1 fault, 2, 3 warning, 4, 5 stop, 8 baseline valid, 9 baseline exceeded", 0, 10, measurementCount},
    Register{"MEAS_VALUE", 10, Float, 2, Read, "", "value of measurement M", 0, 10, measurementCount},
    Register{"MEAS_FS_PERC", 12, U16S, 1, Read, "%", "value as a share of the scale", 0, 10, measurementCount},
    Register{"MEAS_BASELINE_PERC", 13, U16S, 1, Read, "%", "value to compare with as a share of the scale", 0, 10, measurementCount},
};

/// Section 2.4: SET, counted from its first register.
inline constexpr std::array settingRegisters{
    Register{"CUSTOM_NAME", 0, Text, 32, ReadWrite, "", "name given by the user, UTF-8"},
    Register{"IP_ADDR", 32, IpAddress, 2, ReadWrite, "", "IPv4 address"},
    Register{"IP_MASK", 34, IpAddress, 2, ReadWrite, "", "mask of the network"},
    Register{"IP_GATE", 36, IpAddress, 2, ReadWrite, "", "IPv4 address of the gateway"},
    Register{"CH_EN_MASK", 112, U16, 1, ReadWrite, "", "bit I: measurements may be made of channel I"},
    Register{"CH_SENS_PWR", 113, U16, 1, ReadWrite, "", "bit I: the sensor of channel I is fed"},
    Register{"WF_ACQ_TIME", 114, U16, 1, ReadWrite, "ms", "length of a waveform, 1…4000"},
    Register{"CH_SENSOR_K", 142, Float, 2, ReadWrite, "mV/g", "K of volts to the physical quantity", 386},
    Register{"CH_SENSOR_B", 144, Float, 2, ReadWrite, "mV/g", "B of volts to the physical quantity", 386},
    Register{"MEAS_TYPE", 208, U16, 1, ReadWrite, "", "type of measurement M, 0 not used", 386, 40, measurementCount},
    Register{"MEAS_IIR_HP", 230, Filter, 4, ReadWrite, "", "high-pass filter", 386, 40, measurementCount},
    Register{"MEAS_IIR_LP", 234, Filter, 4, ReadWrite, "", "low-pass filter", 386, 40, measurementCount},
};

/// Section 2.5: IIR, counted from its first register; the fourth is not described.
inline constexpr std::array filterRegisters{
    Register{"IIR_EN", 0, U16, 1, ReadWrite, "", "1: the filter is used"},
    Register{"IIR_FC_L", 1, U16, 1, ReadWrite, "0.1 Hz", "cut-off frequency, low part"},
    Register{"IIR_FC_H", 2, U16, 1, ReadWrite, "6553.6 Hz", "cut-off frequency, high part"},
};

} // namespace table
// clang-format on

using table::channelRegisters;
using table::filterRegisters;
using table::moduleRegisters;
using table::settingRegisters;

namespace detail {

/// Does not compile when there is no such register.
consteval Register named(std::string_view name, const auto &table)
{
    for (const Register &entry : table) {
        if (entry.name == name) {
            return entry;
        }
    }
    throw std::invalid_argument("no such register");
}

} // namespace detail

consteval Register moduleRegister(std::string_view name)
{
    return detail::named(name, moduleRegisters);
}
consteval Register channelRegister(std::string_view name)
{
    return detail::named(name, channelRegisters);
}
consteval Register settingRegister(std::string_view name)
{
    return detail::named(name, settingRegisters);
}
consteval Register filterRegister(std::string_view name)
{
    return detail::named(name, filterRegisters);
}

} // namespace gorizont::lvims
