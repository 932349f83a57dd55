#pragma once

#include "core/devices/lvims/lvimsregisters.h"
#include "core/devices/lvims/lvimssimulatedsignal.h"

#include <QByteArray>

#include <optional>

namespace gorizont::lvims {

/// A module as its registers show it: four channels with mixtures of tones, waveforms and spectra that are kept on command,
/// settings, relays, and what can go wrong with all that. Written from manual 003 beside the codec, with nothing in common but
/// the table of registers. Its time is given.
class SimulatedModule
{
public:
    using Time = std::chrono::microseconds; ///< since the start of the simulation

    explicit SimulatedModule(quint64 seed);

    /// What it answers to the function and data of a request: the same, or an exception.
    QByteArray answer(QByteArrayView pdu, Time now);

    void restart(Time now);
    /// Whether it restarted since the last call: all connections to it are gone then.
    bool takeRestart() { return std::exchange(m_hasRestarted, false); }

    void setTones(int channel, const QList<Tone> &tones);
    void setChannelStatus(int channel, quint16 status); ///< CH_STATUS, from the next update on; FFFFh: its waveforms are empty
    void setUpdatePeriod(Time period) { m_updatePeriod = period; } ///< of CH_STATE; 0: nothing changes by itself
    void setCaptureTime(std::optional<Time> time) { m_captureTime = time; } ///< empty: as long as the waveform is
    void setMode(quint16 mode) { poke(moduleRegister("DEVMODE").address, mode); }
    void setRelays(quint32 state);
    void update(); ///< CH_STATE of all channels, now

    /// Another client changes the selection of waveform and spectrum, each time between the write and the read of the next
    /// \a count requests.
    void meddle(int count) { m_meddling = count; }
    /// \a count requests, those after the next \a after ones, are answered with this exception.
    void refuse(quint8 code, int after = 0, int count = 1);

    int requests() const { return m_requests; } ///< answered so far
    quint16 peek(int address) const { return m_registers[static_cast<std::size_t>(address)]; }

    static constexpr double waveformRate = 25600; ///< Hz
    static constexpr double spectrumRates[] = {12800, 512}; ///< Hz
    static constexpr int spectrumSize = 4096; ///< samples, and numbers of the result
    static constexpr double voltsOfCode = 10.0 / 8388608;
    static constexpr double voltsOffset = 0.001; ///< V
    static constexpr double mmOfCode = voltsOfCode * 1000 / 100 * 9806.65; ///< mm/s², at 100 mV/g
    static constexpr double mmOffset = 0.25; ///< mm/s²

private:
    struct Channel
    {
        SimulatedSignal signal{{}};
        quint16 status = 0;
        QList<qint32> waveform; ///< codes
        QList<qint32> spectra[2]; ///< codes, real and imaginary in turns
    };

    void poke(int address, quint16 value) { m_registers[static_cast<std::size_t>(address)] = value; }
    void pokeDouble(int address, quint32 value);
    void pokeReal(int address, double value);
    void pokeText(const Register &entry, const QByteArray &text);
    void fillIdentity(quint64 seed);
    void fillSettings();
    void catchUp(Time now);
    void finishCapture(Time now);
    void keepSpectra(Time now);
    void showState(int channel, int at);
    void count(const Register &entry, int channel = 0);

    QByteArray obey(QByteArrayView pdu, Time now);
    std::optional<QByteArray> read(int first, int count);
    quint8 write(int first, const QList<quint16> &values, Time now);
    quint8 command(int first, const QList<quint16> &values, Time now);
    void changeSettings(quint32 command);
    bool showSelection(int first, int end);
    bool showWaveform(int first, int end);
    bool showSpectrum(int first, int end);
    void showInformation(const Register &first, qsizetype size, double rate);
    void meddleNow();

    std::vector<quint16> m_registers;
    std::vector<quint16> m_flash;
    std::array<Channel, channelCount> m_channels;
    Time m_updatePeriod = std::chrono::seconds(1);
    Time m_updatedAt{0};
    std::optional<Time> m_captureTime;
    std::optional<Time> m_captureEnds;
    int m_meddling = 0;
    int m_refuseAfter = 0;
    int m_refusals = 0;
    quint8 m_refusal = 0;
    int m_requests = 0;
    bool m_hasRestarted = false;
};

} // namespace gorizont::lvims
