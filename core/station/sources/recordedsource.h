#pragma once

#include "core/station/sources/source.h"
#include "core/station/sources/sourcefile.h"

#include <QList>

namespace gorizont::station {

/// Values of the past, in ascending time. Text: the first line names the columns, `time` and channels of ACK.SRC (a wind is two
/// of them, `v1.speed` and `v1.direction`); then one moment a line: seconds, and a number or a dash for every channel.
struct RecordedValues
{
    struct Moment
    {
        double time = 0; ///< s
        RawSample sample;
    };
    QList<Moment> moments;

    /// The values at \a time: those of the last moment that is not after it. nullptr: it is before the first one.
    const RawSample *at(double time) const;
};

/// Empty: \a problem says in which line something is wrong.
std::optional<RecordedValues> readRecording(const QByteArray &text, QString *problem);

/// A recorded file, replayed in real time from its beginning; at its end it begins anew, or there are no values any more.
class RecordedSource : public Source
{
public:
    RecordedSource(const Recording &recording, double rate)
        : m_recording(recording)
        , m_rate(rate)
    {
    }

    QString name() const override;
    double rate() const override { return m_rate; }
    QString open() override;
    QString measure(const SampleMoment &moment, RawSample &sample) override;

private:
    Recording m_recording;
    double m_rate; ///< Hz
    RecordedValues m_values;
};

} // namespace gorizont::station
