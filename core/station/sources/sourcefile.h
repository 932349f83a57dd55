#pragma once

#include "core/station/sources/signal.h"
#include "core/station/stationcomplaint.h"

#include <QByteArray>
#include <QList>

#include <array>
#include <map>

namespace gorizont::station {

/// What a channel of ACK.SRC is.
enum class ChannelKind : quint8 {
    Analogue, ///< a1 … a64: the places in the strings of ACK.LCD; those of ACK.FWL, or, when there are both files, from a33 on
    Frequency, ///< f1: the frequency input, Hz
    Digital, ///< d1 … d32: the digital inputs, bit 0 is d1
    Pulses, ///< p1 … p32: pulses a second on a digital input, of a gamma sensor
    Wind, ///< v1 … v4: the wind sensors whose parameters are A1 and M1 … A4 and M4
    Output, ///< o1 … o32: the outputs, bit 0 is o1
};

struct SourceChannel
{
    ChannelKind kind = ChannelKind::Analogue;
    int index = 0; ///< 0…
    bool operator==(const SourceChannel &) const = default;
    auto operator<=>(const SourceChannel &) const = default;
};

/// A channel that is read from, or written to, files of the system.
struct FileChannel
{
    SourceChannel channel;
    QString path; ///< of iio: the folder of the device; absolute, or beside ACK.SRC
    int input = -1; ///< M of in_voltageM_raw; -1: no iio, the file holds the number
    bool operator==(const FileChannel &) const = default;
};

/// A signal that is only there while an output is on: pulses of a gamma sensor while its blinker is open.
struct OutputSignal
{
    SourceChannel channel;
    double level = 0;
    int output = 0; ///< bit
    bool operator==(const OutputSignal &) const = default;
};

struct Recording
{
    QString path; ///< absolute, or beside ACK.SRC
    bool isRepeated = true;
    bool operator==(const Recording &) const = default;
};

/// ACK.SRC, an addition of ours to the files of the station: where the values of the channels come from, now that the boards are gone.
struct SourcePlan
{
    static constexpr double fastest = 1000; ///< Hz

    double rate = 10; ///< Hz: how often signals are calculated and files are read
    std::multimap<SourceChannel, Signal> signals_;
    QList<OutputSignal> outputSignals;
    std::map<int, Vane> vanes; ///< by index of the wind sensor, 0…
    QList<FileChannel> files;
    QList<Recording> recordings;
    bool operator==(const SourcePlan &) const = default;

    bool hasSignals() const { return !signals_.empty() || !outputSignals.isEmpty() || !vanes.empty(); }
};

/// One record a line, `;` begins a comment:
///
///     rate HZ
///     CHANNEL constant VALUE | sine MEAN AMPLITUDE PERIOD [PHASE] | noise MEAN DEVIATION
///     CHANNEL drop VALUE BY EVERY FOR | square LOW HIGH PERIOD FOR | output VALUE BIT
///     vN vane SPEED GUST DIRECTION SWING PERIOD
///     CHANNEL iio FOLDER INPUT | file PATH
///     record FILE [once]
///
/// Lines of one channel add up. A faulty line is left out and complained about. \a folder is where relative paths begin.
SourcePlan readSources(const QString &file, const QByteArray &bytes, const QString &folder, Complaints &complaints);

/// `a1` … `o32`. Empty: there is no such channel.
std::optional<SourceChannel> channelOf(QStringView name);

} // namespace gorizont::station
