#include "core/devices/lvims/lvimscapture.h"

#include "core/devices/attempts.h"

namespace gorizont::lvims {

namespace {

using namespace std::chrono_literals;

constexpr quint16 keepWaveform = 0x5649;
constexpr quint16 keepSpectra = 0x5651;
constexpr auto betweenLooks = 20ms;
constexpr quint32 largest = 1'000'000; ///< samples; 4 s at the fastest rate of such a module are fewer

constexpr Range waveformInformation{
    moduleRegister("WF_INFO_CH").address,
    moduleRegister("WF_INFO_CHST").address + channelStateSize - moduleRegister("WF_INFO_CH").address};
constexpr Range spectrumInformation =
    Range::from(moduleRegister("SPECTR_INFO_CH"), moduleRegister("SPECTR_INFO_WND_SUM2"));

constexpr int echoSize = 4; ///< registers: channel, ID or type, offset

/// WF_INFO_CHST carries no number of its own.
CaptureInformation describedWaveform(const Words &words)
{
    CaptureInformation information;
    information.channel = words.word(moduleRegister("WF_INFO_CH"));
    information.id = words.word(moduleRegister("WF_INFO_ID"));
    information.size = words.doubleWord(moduleRegister("WF_INFO_SIZE"));
    information.rate = words.real(moduleRegister("WF_INFO_FREQ"));
    information.voltsK = words.real(moduleRegister("WF_INFO_E_K"));
    information.voltsB = words.real(moduleRegister("WF_INFO_E_B"));
    information.physicalK = words.real(moduleRegister("WF_INFO_P_K"));
    information.physicalB = words.real(moduleRegister("WF_INFO_P_B"));
    information.state = channelOf(words.set(moduleRegister("WF_INFO_CHST")), information.channel, {});
    return information;
}

CaptureInformation describedSpectrum(const Words &words)
{
    CaptureInformation information;
    information.channel = words.word(moduleRegister("SPECTR_INFO_CH"));
    information.id = words.word(moduleRegister("SPECTR_INFO_TYPE"));
    information.size = words.doubleWord(moduleRegister("SPECTR_INFO_SIZE"));
    information.rate = words.real(moduleRegister("SPECTR_INFO_DECI_FREQ"));
    information.voltsK = words.real(moduleRegister("SPECTR_INFO_E_K"));
    information.voltsB = words.real(moduleRegister("SPECTR_INFO_E_B"));
    information.physicalK = words.real(moduleRegister("SPECTR_INFO_P_K"));
    information.physicalB = words.real(moduleRegister("SPECTR_INFO_P_B"));
    information.windowSum = words.real(moduleRegister("SPECTR_INFO_WND_SUM"));
    information.windowSum2 = words.real(moduleRegister("SPECTR_INFO_WND_SUM2"));
    return information;
}

} // namespace

Capture::Capture(Link link, Kind kind, int channel)
    : m_link(std::move(link))
    , m_kind(kind)
    , m_channel(channel)
{
}

std::chrono::milliseconds Capture::pause() const
{
    return m_phase == Phase::Wait ? betweenLooks : 0ms;
}

Result<void> Capture::step(Line &line, SteadyTime now)
{
    switch (m_phase) {
    case Phase::Look: return look(line);
    case Phase::Trigger: return trigger(line, now);
    case Phase::Wait: return wait(line, now);
    case Phase::Inform: return inform(line);
    case Phase::Fetch: return fetch(line);
    case Phase::Done: break;
    }
    return {};
}

/// What was there before, and how long a waveform takes.
Result<void> Capture::look(Line &line)
{
    if (!isWaveform()) {
        m_phase = Phase::Trigger;
        return {};
    }
    const auto status = withAttempts([&] { return m_link.read(line, statusRange); });
    if (!status) {
        return status.fault();
    }
    m_before = status->word(moduleRegister("ST_WF_UP_ID"), m_channel);
    constexpr auto lengthAt =
        static_cast<quint16>(moduleRegister("CUR_SETTINGS").address + settingRegister("WF_ACQ_TIME").address);
    const auto length = withAttempts([&] { return m_link.read(line, {lengthAt, 1}); });
    if (!length) {
        return length.fault();
    }
    m_length = std::chrono::milliseconds(length->values().value(0));
    m_phase = Phase::Trigger;
    return {};
}

Result<void> Capture::trigger(Line &line, SteadyTime now)
{
    const quint16 command = isWaveform() ? keepWaveform : keepSpectra;
    const auto written =
        withAttempts([&] { return m_link.write(line, moduleRegister("CMD_INPUT").address, {command}); });
    if (!written) {
        return written.fault();
    }
    m_deadline = now + 2 * m_length + 1s;
    m_phase = isWaveform() ? Phase::Wait : Phase::Inform;
    return {};
}

Result<void> Capture::wait(Line &line, SteadyTime now)
{
    const auto words = withAttempts([&] { return m_link.read(line, statusRange); });
    if (!words) {
        return words.fault();
    }
    const Status::Channel status = statusOf(*words).channels[static_cast<std::size_t>(m_channel)];
    m_wasBusy = m_wasBusy || status.waveformsReady == 0;
    if (status.waveformsReady != 0 && (m_wasBusy || status.waveform != m_before)) {
        m_id = status.waveform;
        m_phase = Phase::Inform;
        return {};
    }
    m_isLate = now > m_deadline;
    return m_isLate ? Result<void>(Fault::Timeout) : Result<void>();
}

QList<quint16> Capture::selection(quint32 offset) const
{
    return QList<quint16>{static_cast<quint16>(m_channel), selector()} + fromDoubleWord(offset);
}

Result<Words> Capture::select(Line &line, quint32 offset, const Range &range)
{
    const quint16 first = moduleRegister("WF_RD_CH").address;
    const quint16 firstOfSpectra = moduleRegister("SPECTR_RD_CH").address;
    return withAttempts(
        [&] { return m_link.writeAndRead(line, isWaveform() ? first : firstOfSpectra, selection(offset), range); });
}

Result<void> Capture::inform(Line &line)
{
    const auto words = select(line, 0, isWaveform() ? waveformInformation : spectrumInformation);
    if (!words) {
        return words.fault() == Fault::Refused ? again(Fault::Refused) : words.fault();
    }
    m_information = isWaveform() ? describedWaveform(*words) : describedSpectrum(*words);
    if (m_information.channel != m_channel || m_information.id != selector()) {
        return again(Fault::BadReply);
    }
    const bool isGood = m_information.size > 0 && m_information.size <= largest && m_information.rate > 0
        && (isWaveform() || m_information.windowSum > 0);
    if (!isGood) {
        return Fault::BadReply;
    }
    m_codes.clear();
    m_codes.reserve(m_information.size);
    m_phase = Phase::Fetch;
    return {};
}

/// The registers of the selection come back before the samples: an echo that is not ours is another client's.
Result<void> Capture::fetch(Line &line)
{
    const auto offset = static_cast<quint32>(m_codes.size());
    const auto count = static_cast<int>(std::min<quint32>(samplesOfAnEcho, m_information.size - offset));
    const quint16 first = (isWaveform() ? moduleRegister("WF_RD_CH") : moduleRegister("SPECTR_RD_CH")).address;
    const auto words = select(line, offset, {first, echoSize + 2 * count});
    if (!words) {
        return words.fault() == Fault::Refused ? again(Fault::Refused) : words.fault();
    }
    const QList<quint16> &values = words->values();
    if (values.first(echoSize) != selection(offset)) {
        return again(Fault::BadReply);
    }
    for (int s = 0; s < count; ++s) {
        const quint32 low = values.at(echoSize + 2 * s);
        const quint32 high = values.at(echoSize + 2 * s + 1);
        m_codes.append(static_cast<qint32>(high << 16 | low));
    }
    m_phase = m_codes.size() == m_information.size ? Phase::Done : Phase::Fetch;
    return {};
}

/// From the state of the module on: another client may have made it keep another waveform meanwhile.
Result<void> Capture::again(Fault reason)
{
    if (++m_disturbances >= mostAttempts) {
        return reason;
    }
    m_codes.clear();
    m_wasBusy = true;
    m_phase = isWaveform() ? Phase::Wait : Phase::Inform;
    return {};
}

} // namespace gorizont::lvims
