#include "core/devices/lvims/lvimssimulatedmodule.h"

#include <algorithm>
#include <span>

/// The conversation of the simulated module: functions 03, 04, 16 and 23, and the registers whose contents depend on what was
/// written before.
namespace gorizont::lvims {

namespace {

constexpr quint8 illegalFunction = 1;
constexpr quint8 illegalAddress = 2;
constexpr quint8 illegalValue = 3;
constexpr int waveformSelection = 36864;
constexpr int waveformInformation = 37120;
constexpr int spectrumSelection = 37376;
constexpr int spectrumInformation = 37632;

struct Span
{
    int first;
    int end;
};
constexpr Span readable[] = {{0, 128},       {1024, 1054},   {1280, 1634},   {36864, 36992}, {37120, 37244},
                             {37376, 37504}, {37632, 37650}, {45056, 52512}, {53248, 60704}};
constexpr Span writable[] = {{36864, 36868}, {37376, 37380}, {53248, 60704}};

bool isWithin(std::span<const Span> spans, int first, int end)
{
    return std::any_of(spans.begin(), spans.end(), [=](const Span &span) {
        return first >= span.first && end <= span.end;
    });
}

int numberAt(QByteArrayView pdu, qsizetype at)
{
    return at + 1 < pdu.size() ? quint8(pdu[at]) * 256 + quint8(pdu[at + 1]) : 0;
}

QList<quint16> valuesAt(QByteArrayView pdu, qsizetype at)
{
    QList<quint16> values;
    for (; at + 1 < pdu.size(); at += 2) {
        values.append(static_cast<quint16>(numberAt(pdu, at)));
    }
    return values;
}

QByteArray exception(QByteArrayView pdu, quint8 code)
{
    const auto function = static_cast<char>(quint8(pdu.isEmpty() ? 0 : pdu[0]) | 0x80);
    return QByteArray(1, function) + static_cast<char>(code);
}

} // namespace

QByteArray SimulatedModule::answer(QByteArrayView pdu, Time now)
{
    catchUp(now);
    ++m_requests;
    if (m_refusals > 0 && m_refuseAfter-- <= 0) {
        --m_refusals;
        return exception(pdu, m_refusal);
    }
    return obey(pdu, now);
}

QByteArray SimulatedModule::obey(QByteArrayView pdu, Time now)
{
    const int function = pdu.isEmpty() ? 0 : quint8(pdu[0]);
    const bool reads = function == 3 || function == 4 || function == 23;
    const bool writes = function == 16 || function == 23;
    if (!reads && !writes) {
        return exception(pdu, illegalFunction);
    }
    const qsizetype place = function == 23 ? 5 : 1;
    const qsizetype head = function == 23 ? 10 : function == 16 ? 6 : 5;
    const int written = writes ? numberAt(pdu, place + 2) : 0;
    const int wanted = reads ? numberAt(pdu, 3) : 1;
    const bool isWhole = pdu.size() == head + 2 * written && (!writes || quint8(pdu[head - 1]) == 2 * written);
    if (!isWhole || wanted < 1 || wanted > 125 || (writes && written < 1)) {
        return exception(pdu, illegalValue);
    }
    if (writes) {
        if (const quint8 code = write(numberAt(pdu, place), valuesAt(pdu, head), now)) {
            poke(moduleRegister("LAST_WR_ERROR").address, code);
            return exception(pdu, code);
        }
        poke(moduleRegister("LAST_WR_ERROR").address, 0);
    }
    if (m_meddling > 0 && reads && numberAt(pdu, 1) >= waveformSelection && numberAt(pdu, 1) < 40960) {
        meddleNow();
    }
    if (!reads) {
        return pdu.first(5).toByteArray();
    }
    const auto data = read(numberAt(pdu, 1), wanted);
    return data ? pdu.first(1).toByteArray() + static_cast<char>(2 * wanted) + *data : exception(pdu, illegalAddress);
}

void SimulatedModule::meddleNow()
{
    --m_meddling;
    poke(waveformSelection, static_cast<quint16>((peek(waveformSelection) + 1) % channelCount));
    poke(waveformSelection + 2, 0);
    poke(spectrumSelection, static_cast<quint16>((peek(spectrumSelection) + 1) % channelCount));
    poke(spectrumSelection + 2, 0);
}

std::optional<QByteArray> SimulatedModule::read(int first, int count)
{
    if (!isWithin(readable, first, first + count) || !showSelection(first, first + count)) {
        return std::nullopt;
    }
    QByteArray data;
    for (int address = first; address < first + count; ++address) {
        data.append(static_cast<char>(peek(address) / 256)).append(static_cast<char>(peek(address) % 256));
    }
    return data;
}

quint8 SimulatedModule::write(int first, const QList<quint16> &values, Time now)
{
    const int end = first + static_cast<int>(values.size());
    if (!isWithin(writable, first, end)) {
        return command(first, values, now);
    }
    std::copy(values.begin(), values.end(), m_registers.begin() + first);
    return 0;
}

quint8 SimulatedModule::command(int first, const QList<quint16> &values, Time now)
{
    if (first == 40960 && values == QList<quint16>{0x5649}) {
        for (int i = 0; i < channelCount; ++i) {
            poke(moduleRegister("ST_WF_RDY_CNT").at(i), 0);
        }
        m_captureEnds = now + m_captureTime.value_or(std::chrono::milliseconds(peek(45056 + 114)));
    } else if (first == 40960 && values == QList<quint16>{0x5651}) {
        keepSpectra(now);
    } else if (first == 61440 && values.size() == 2 && values.at(1) == 0x5649) {
        changeSettings(quint32(values.at(1)) << 16 | values.at(0));
    } else if (first == 65280 && values == QList<quint16>{0x424F, 0x4F53, 0x5245, 0x5354}) {
        restart(now);
    } else {
        return first == 40960 || first == 61440 || first == 65280 ? illegalValue : illegalAddress;
    }
    return 0;
}

/// Fills in what is selected, as far as it is read. False: it cannot be read.
bool SimulatedModule::showSelection(int first, int end)
{
    return showWaveform(first, end) && showSpectrum(first, end);
}

bool SimulatedModule::showWaveform(int first, int end)
{
    const bool isData = first < waveformSelection + 128 && end > waveformSelection + 4;
    const bool isInformation = first < waveformInformation + 124 && end > waveformInformation;
    if (!isData && !isInformation) {
        return true;
    }
    const int channel = peek(waveformSelection);
    if (channel >= channelCount || peek(moduleRegister("ST_WF_RDY_CNT").at(channel)) == 0
        || peek(waveformSelection + 1) != peek(moduleRegister("ST_WF_UP_ID").at(channel))) {
        return false;
    }
    const QList<qint32> &codes = m_channels[static_cast<std::size_t>(channel)].waveform;
    if (isInformation) {
        poke(waveformInformation, peek(waveformSelection));
        poke(waveformInformation + 1, peek(waveformSelection + 1));
        showInformation(moduleRegister("WF_INFO_SIZE"), codes.size(), waveformRate);
        showState(channel, waveformInformation + 36);
        return true;
    }
    const qint64 offset = peek(waveformSelection + 2) + 65536LL * peek(waveformSelection + 3);
    const int samples = (end - waveformSelection - 4 + 1) / 2;
    for (int s = 0; s < samples; ++s) {
        if (offset + s >= codes.size()) {
            return false;
        }
        pokeDouble(waveformSelection + 4 + 2 * s, static_cast<quint32>(codes.at(offset + s)));
    }
    return true;
}

bool SimulatedModule::showSpectrum(int first, int end)
{
    const bool isData = first < spectrumSelection + 128 && end > spectrumSelection + 4;
    const bool isInformation = first < spectrumInformation + 18 && end > spectrumInformation;
    if (!isData && !isInformation) {
        return true;
    }
    const int channel = peek(spectrumSelection);
    const int type = peek(spectrumSelection + 1);
    if (channel >= channelCount || type > 1) {
        return false;
    }
    const QList<qint32> &codes = m_channels[static_cast<std::size_t>(channel)].spectra[type];
    if (codes.isEmpty()) {
        return false;
    }
    if (isInformation) {
        poke(spectrumInformation, peek(spectrumSelection));
        poke(spectrumInformation + 1, peek(spectrumSelection + 1));
        showInformation(moduleRegister("SPECTR_INFO_SIZE"), codes.size(), spectrumRates[type]);
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < spectrumSize; ++i) {
            sum += blackman(i, spectrumSize);
            squares += blackman(i, spectrumSize) * blackman(i, spectrumSize);
        }
        pokeReal(spectrumInformation + 14, sum);
        pokeReal(spectrumInformation + 16, squares);
        return true;
    }
    const qint64 offset = peek(spectrumSelection + 2) + 65536LL * peek(spectrumSelection + 3);
    const int numbers = (end - spectrumSelection - 4 + 1) / 2;
    for (int s = 0; s < numbers; ++s) {
        if (offset + s >= codes.size()) {
            return false;
        }
        pokeDouble(spectrumSelection + 4 + 2 * s, static_cast<quint32>(codes.at(offset + s)));
    }
    return true;
}

/// From the size on, waveform and spectrum are described alike.
void SimulatedModule::showInformation(const Register &first, qsizetype size, double rate)
{
    pokeDouble(first.address, static_cast<quint32>(size));
    pokeReal(first.address + 2, rate);
    pokeReal(first.address + 4, voltsOfCode);
    pokeReal(first.address + 6, voltsOffset);
    pokeReal(first.address + 8, mmOfCode);
    pokeReal(first.address + 10, mmOffset);
}

} // namespace gorizont::lvims
