#include "core/station/sources/recordedsource.h"

#include "core/station/stationtext.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <algorithm>
#include <cmath>

namespace gorizont::station {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 longestFile = 64LL * 1024 * 1024; ///< bytes

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::RecordedSource)
};

/// Puts the number of one column into a sample.
using Put = std::function<void(RawSample &sample, double value)>;

Put putWind(const SourceChannel &channel, const QString &part)
{
    const auto index = static_cast<std::size_t>(channel.index);
    if (part == u"speed") {
        return [index](RawSample &sample, double value) { sample.winds[index].frequency = value; };
    }
    if (part == u"direction") {
        return [index](RawSample &sample, double value) { sample.winds[index].phase = value; };
    }
    return {};
}

/// Empty: there is no such column.
Put putOf(const QString &column)
{
    const qsizetype point = column.indexOf(u'.');
    const auto channel = channelOf(point < 0 ? column : column.first(point));
    if (!channel || channel->kind == ChannelKind::Output) {
        return {};
    }
    if (channel->kind == ChannelKind::Wind || point >= 0) {
        return channel->kind == ChannelKind::Wind ? putWind(*channel, column.sliced(point + 1).toLower()) : Put();
    }
    const auto index = static_cast<std::size_t>(channel->index);
    switch (channel->kind) {
    case ChannelKind::Analogue: return [index](RawSample &sample, double value) { sample.analogue[index] = value; };
    case ChannelKind::Pulses: return [index](RawSample &sample, double value) { sample.pulses[index] = value; };
    case ChannelKind::Digital: return [index](RawSample &sample, double value) { sample.digital[index] = value != 0; };
    default: return [](RawSample &sample, double value) { sample.frequency = value; };
    }
}

QString inLine(const Record &record, const QString &problem)
{
    return Text::tr("line %1: %2").arg(record.line).arg(problem);
}

/// Empty: \a problem says why.
std::optional<QList<Put>> columnsOf(const Record &record, QString *problem)
{
    if (record.fields.constFirst().text.compare(u"time"_s, Qt::CaseInsensitive) != 0) {
        *problem = inLine(record, Text::tr("the first column must be called time"));
        return std::nullopt;
    }
    QList<Put> columns;
    for (qsizetype i = 1; i < record.fields.size(); ++i) {
        columns.append(putOf(record.fields.at(i).text));
        if (!columns.constLast()) {
            *problem = inLine(record, Text::tr("%1 is no channel").arg(quoted(record.fields.at(i).text)));
            return std::nullopt;
        }
    }
    return columns;
}

/// Empty: \a problem says why.
std::optional<RecordedValues::Moment> momentOf(const Record &record, const QList<Put> &columns, QString *problem)
{
    if (record.fields.size() != columns.size() + 1) {
        *problem = inLine(record, Text::tr("%n value(s) are expected", nullptr, static_cast<int>(columns.size()) + 1));
        return std::nullopt;
    }
    RecordedValues::Moment moment;
    for (qsizetype i = 0; i < record.fields.size(); ++i) {
        if (i > 0 && record.fields.at(i).isNone()) {
            continue;
        }
        const auto value = numberOf(record.fields.at(i).text);
        if (!value) {
            *problem = inLine(record, Text::tr("%1 is no number").arg(quoted(record.fields.at(i).text)));
            return std::nullopt;
        }
        if (i == 0) {
            moment.time = *value;
        } else {
            columns.at(i - 1)(moment.sample, *value);
        }
    }
    return moment;
}

} // namespace

const RawSample *RecordedValues::at(double time) const
{
    const auto after = std::upper_bound(moments.begin(), moments.end(), time, [](double t, const Moment &moment) {
        return t < moment.time;
    });
    return after == moments.begin() ? nullptr : &std::prev(after)->sample;
}

std::optional<RecordedValues> readRecording(const QByteArray &text, QString *problem)
{
    const QList<Record> records = recordsOf(decodeStationText(text));
    if (records.size() < 2) {
        *problem = Text::tr("it holds no values");
        return std::nullopt;
    }
    const auto columns = columnsOf(records.constFirst(), problem);
    if (!columns) {
        return std::nullopt;
    }
    RecordedValues values;
    for (const Record &record : records.sliced(1)) {
        const auto moment = momentOf(record, *columns, problem);
        if (!moment) {
            return std::nullopt;
        }
        if (!values.moments.isEmpty() && moment->time <= values.moments.constLast().time) {
            *problem = inLine(record, Text::tr("the time does not go on"));
            return std::nullopt;
        }
        values.moments.append(*moment);
    }
    return values;
}

QString RecordedSource::name() const
{
    return QDir::toNativeSeparators(m_recording.path);
}

QString RecordedSource::open()
{
    QFile file(m_recording.path);
    if (!file.open(QIODevice::ReadOnly)) {
        return file.errorString();
    }
    if (file.size() > longestFile) {
        return Text::tr("it is longer than 64 MB");
    }
    QString problem;
    auto values = readRecording(file.readAll(), &problem);
    if (values) {
        m_values = *std::move(values);
    }
    return problem;
}

/// The last moment lasts as long as the one before it.
QString RecordedSource::measure(const SampleMoment &moment, RawSample &sample)
{
    const auto &all = m_values.moments;
    const double begin = all.constFirst().time;
    const double last = all.size() > 1 ? all.constLast().time - all.at(all.size() - 2).time : 1;
    const double length = all.constLast().time - begin + last;
    double passed = moment.time.count();
    if (passed >= length && !m_recording.isRepeated) {
        return {};
    }
    passed = std::fmod(passed, length);
    if (const RawSample *known = m_values.at(begin + passed)) {
        fillFrom(sample, *known);
    }
    return {};
}

} // namespace gorizont::station
