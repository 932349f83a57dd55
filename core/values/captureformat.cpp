#include "core/values/captureformat.h"

#include <QtEndian>

#include <bit>
#include <cmath>

namespace gorizont {

namespace {

constexpr int digits = 9; ///< as many as a float has

QByteArray number(double value)
{
    return QByteArray::number(value, 'g', digits);
}

template <typename T> void appendLittle(QByteArray &bytes, T value)
{
    const T little = qToLittleEndian(value);
    bytes.append(reinterpret_cast<const char *>(&little), sizeof little);
}

} // namespace

QByteArray waveformCsv(const CaptureInformation &information, const QList<qint32> &codes)
{
    QByteArray csv = "time,code,value\n";
    for (qsizetype i = 0; i < codes.size(); ++i) {
        csv += number(information.time(i)) + ',' + QByteArray::number(codes.at(i)) + ','
            + number(information.physical(codes.at(i))) + '\n';
    }
    return csv;
}

QByteArray spectrumCsv(const CaptureInformation &information, const QList<qint32> &codes)
{
    QByteArray csv = "frequency,amplitude\n";
    for (const SpectrumBin &bin : spectrumOf(information, codes)) {
        csv += number(bin.frequency) + ',' + number(bin.amplitude) + '\n';
    }
    return csv;
}

/// RIFF, `fmt ` of 16 bytes with format 3 (float), `data`.
QByteArray waveformWav(const CaptureInformation &information, const QList<qint32> &codes)
{
    constexpr quint16 floatFormat = 3;
    constexpr quint16 sampleSize = sizeof(float);
    constexpr quint32 headSize = 36; ///< bytes of the header that the first length counts
    const auto rate = static_cast<quint32>(std::lround(information.rate));
    const auto size = static_cast<quint32>(codes.size() * sampleSize);
    double largest = 0;
    for (const qint32 code : codes) {
        largest = std::max(largest, std::abs(information.physical(code)));
    }
    QByteArray wav = "RIFF";
    appendLittle(wav, headSize + size);
    wav += "WAVEfmt ";
    appendLittle(wav, quint32(16));
    appendLittle(wav, floatFormat);
    appendLittle(wav, quint16(1));
    appendLittle(wav, rate);
    appendLittle(wav, rate * sampleSize);
    appendLittle(wav, sampleSize);
    appendLittle(wav, quint16(8 * sampleSize));
    wav += "data";
    appendLittle(wav, size);
    for (const qint32 code : codes) {
        const double value = largest > 0 ? information.physical(code) / largest : 0;
        appendLittle(wav, std::bit_cast<quint32>(static_cast<float>(value)));
    }
    return wav;
}

} // namespace gorizont
