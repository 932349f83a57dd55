#include "core/devices/lvims/lvimssimulatedmodule.h"

#include <bit>
#include <cmath>

namespace gorizont::lvims {

namespace {

constexpr int cur = moduleRegister("CUR_SETTINGS").address;
constexpr int mut = moduleRegister("MUT_SETTINGS").address;
constexpr int acquisition = settingRegister("WF_ACQ_TIME").address;
constexpr quint16 noData = 0xFFFF; ///< CH_STATUS
constexpr double fullScaleCode = 10000; ///< of 100 %
constexpr double fullScales[] = {20000, 100, 1000}; ///< of the first three measurements: mm/s², mm/s, µm

double secondsOf(SimulatedModule::Time time)
{
    return std::chrono::duration<double>(time).count();
}

qint32 codeOf(double value)
{
    return static_cast<qint32>(std::lround(value));
}

} // namespace

SimulatedModule::SimulatedModule(quint64 seed)
    : m_registers(65536, 0)
{
    fillIdentity(seed);
    fillSettings();
    m_flash.assign(m_registers.begin() + cur, m_registers.begin() + cur + settingsSize);
    for (int i = 0; i < channelCount; ++i) {
        const double basic = 25 + 10 * i + static_cast<double>(seed % 5);
        setTones(i, {{basic, 400.0 + 100 * i, 0}, {2 * basic, 150, 1}, {1000.0 + 250 * i, 2000, 2}});
    }
    update();
}

void SimulatedModule::pokeDouble(int address, quint32 value)
{
    poke(address, static_cast<quint16>(value));
    poke(address + 1, static_cast<quint16>(value >> 16));
}

void SimulatedModule::pokeReal(int address, double value)
{
    pokeDouble(address, std::bit_cast<quint32>(static_cast<float>(value)));
}

void SimulatedModule::pokeText(const Register &entry, const QByteArray &text)
{
    for (int i = 0; i < entry.size; ++i) {
        const QByteArray pair = text.mid(2 * i, 2).leftJustified(2, '\0');
        poke(entry.address + i, static_cast<quint16>(quint8(pair[0]) + 256 * quint8(pair[1])));
    }
}

void SimulatedModule::fillIdentity(quint64 seed)
{
    pokeText(moduleRegister("DEVNAME"), "VIMS_ICP");
    pokeText(moduleRegister("SERIAL"), "7S" + QByteArray::number(100000 + seed % 900000));
    pokeText(moduleRegister("FWVER"), "1.0.7");
    pokeText(moduleRegister("BRD_REV"), "2");
    setMode(2);
}

void SimulatedModule::fillSettings()
{
    const QByteArray name("Насос 1");
    Register entry = settingRegister("CUSTOM_NAME");
    for (const int base : {cur, mut}) {
        entry.address = static_cast<quint16>(base);
        pokeText(entry, name);
        pokeDouble(base + settingRegister("IP_ADDR").address, 0x0A01A8C0); // 192.168.1.10
        pokeDouble(base + settingRegister("IP_MASK").address, 0x00FFFFFF);
        pokeDouble(base + settingRegister("IP_GATE").address, 0x0101A8C0);
        poke(base + settingRegister("CH_EN_MASK").address, 0x000F);
        poke(base + settingRegister("CH_SENS_PWR").address, 0x000F);
        poke(base + acquisition, 500);
        for (int i = 0; i < channelCount; ++i) {
            pokeReal(base + settingRegister("CH_SENSOR_K").at(i), 100);
            for (int m = 0; m < 3; ++m) {
                poke(base + settingRegister("MEAS_TYPE").at(i, m), static_cast<quint16>(m + 1));
            }
        }
    }
}

void SimulatedModule::restart(Time now)
{
    for (int address = 1024; address <= 1053; ++address) {
        poke(address, 0);
    }
    for (const int base : {cur, mut}) {
        std::copy(m_flash.begin(), m_flash.end(), m_registers.begin() + base);
    }
    for (Channel &channel : m_channels) {
        channel.waveform.clear();
        channel.spectra[0].clear();
        channel.spectra[1].clear();
    }
    m_captureEnds.reset();
    m_updatedAt = now;
    m_hasRestarted = true;
    update();
}

void SimulatedModule::setTones(int channel, const QList<Tone> &tones)
{
    m_channels[static_cast<std::size_t>(channel)].signal = SimulatedSignal(tones);
}

void SimulatedModule::setChannelStatus(int channel, quint16 status)
{
    m_channels[static_cast<std::size_t>(channel)].status = status;
}

void SimulatedModule::setRelays(quint32 state)
{
    pokeDouble(moduleRegister("RELE_STATE").address, state);
    count(moduleRegister("OUTSYS_UP_ID"));
}

void SimulatedModule::refuse(quint8 code, int after, int count)
{
    m_refusal = code;
    m_refuseAfter = after;
    m_refusals = count;
}

void SimulatedModule::count(const Register &entry, int channel)
{
    poke(entry.at(channel), static_cast<quint16>(peek(entry.at(channel)) + 1));
}

void SimulatedModule::update()
{
    for (int i = 0; i < channelCount; ++i) {
        showState(i, moduleRegister("CH_STATE").at(i));
        count(moduleRegister("ST_CH_UP_ID"), i);
    }
}

/// CHST of \a channel at the address \a at.
void SimulatedModule::showState(int channel, int at)
{
    const Channel &shown = m_channels[static_cast<std::size_t>(channel)];
    const double values[] = {
        shown.signal.accelerationRms(), shown.signal.velocityRms(), shown.signal.displacementRms()};
    poke(at, shown.status);
    for (int m = 0; m < measurementCount; ++m) {
        const int base = at + 8 + 10 * m;
        const quint16 type = peek(cur + settingRegister("MEAS_TYPE").at(channel, m));
        const bool isMeasured = type >= 1 && type <= 3 && shown.status == 0;
        const double value = isMeasured ? values[type - 1] : 0;
        const double share = isMeasured ? value / fullScales[type - 1] : 0;
        const int level = share > 0.9 ? 0x14 : share > 0.5 ? 0x04 : 0; // warning, with it stop
        const int unknown = 0x28; // warning and stop: Z
        poke(base, type);
        poke(base + 1, static_cast<quint16>(shown.status == 0 ? level : unknown | (shown.status == 0xFFFF ? 2 : 1)));
        pokeReal(base + 2, value);
        poke(base + 4, static_cast<quint16>(std::min(65535L, std::lround(share * fullScaleCode))));
    }
}

void SimulatedModule::catchUp(Time now)
{
    if (m_updatePeriod > Time(0) && now - m_updatedAt >= m_updatePeriod) {
        m_updatedAt = now;
        update();
    }
    if (m_captureEnds && now >= *m_captureEnds) {
        finishCapture(*m_captureEnds);
    }
}

/// The waveform is what was felt until \a now.
void SimulatedModule::finishCapture(Time now)
{
    m_captureEnds.reset();
    const int size = static_cast<int>(peek(cur + acquisition) * waveformRate / 1000);
    for (int i = 0; i < channelCount; ++i) {
        Channel &channel = m_channels[static_cast<std::size_t>(i)];
        channel.waveform.clear();
        for (int s = 0; s < size && channel.status != noData; ++s) {
            const double at = secondsOf(now) - (size - s) / waveformRate;
            channel.waveform.append(codeOf(channel.signal.acceleration(at) / mmOfCode));
        }
        count(moduleRegister("ST_WF_UP_ID"), i);
        poke(moduleRegister("ST_WF_RDY_CNT").at(i), 1);
    }
}

void SimulatedModule::keepSpectra(Time now)
{
    for (int i = 0; i < channelCount; ++i) {
        Channel &channel = m_channels[static_cast<std::size_t>(i)];
        for (int type = 0; type < 2; ++type) {
            QList<qint32> &codes = channel.spectra[type];
            codes.clear();
            for (const auto &bin :
                 channel.signal.spectrum(secondsOf(now), spectrumRates[type], spectrumSize, mmOfCode)) {
                codes << codeOf(bin.real()) << codeOf(bin.imag());
            }
        }
        count(moduleRegister("ST_SPEC_5000_UP_ID"), i);
        count(moduleRegister("ST_SPEC_200_UP_ID"), i);
        poke(moduleRegister("ST_SPEC_5000_RDY_CNT").at(i), 1);
        poke(moduleRegister("ST_SPEC_200_RDY_CNT").at(i), 1);
    }
}

void SimulatedModule::changeSettings(quint32 command)
{
    const auto copy = [this](const std::vector<quint16> &from, int to) {
        std::copy(from.begin(), from.end(), m_registers.begin() + to);
    };
    const std::vector<quint16> wanted(m_registers.begin() + mut, m_registers.begin() + mut + settingsSize);
    const int milliseconds = peek(mut + acquisition);
    const bool isGood = milliseconds >= 1 && milliseconds <= 4000;
    if (command == 0x564942AA) {
        copy(m_flash, cur);
        copy(m_flash, mut);
    } else {
        pokeDouble(moduleRegister("LAST_CHECK_SETTINGS_ERR").address, isGood ? 0 : 2);
        if (!isGood) {
            return;
        }
        if (command == 0x56494253) {
            m_flash = wanted;
            return;
        }
        copy(wanted, cur);
    }
    count(moduleRegister("ST_SET_UP_ID"));
    update();
}

} // namespace gorizont::lvims
