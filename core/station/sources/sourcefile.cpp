#include "core/station/sources/sourcefile.h"

#include "core/station/sources/rawsample.h"
#include "core/station/stationtext.h"

#include <QCoreApplication>
#include <QDir>

namespace gorizont::station {

using namespace Qt::Literals::StringLiterals;

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::SourceFile)
};

struct KindOfChannel
{
    QChar letter;
    ChannelKind kind;
    std::size_t count;
};

constexpr std::array<KindOfChannel, 6> kinds{{
    {u'a', ChannelKind::Analogue, mostAnalogue},
    {u'f', ChannelKind::Frequency, 1},
    {u'd', ChannelKind::Digital, mostDigital},
    {u'p', ChannelKind::Pulses, mostDigital},
    {u'v', ChannelKind::Wind, mostWinds},
    {u'o', ChannelKind::Output, mostDigital},
}};

/// How many numbers a kind of signal takes, and which of them must be > 0.
struct Shape
{
    QLatin1StringView word;
    Signal::Kind kind;
    qsizetype least;
    qsizetype most;
    qsizetype positive; ///< index of the period; -1: none
};

const std::array<Shape, 5> shapes{{
    {QLatin1StringView("constant"), Signal::Kind::Constant, 1, 1, -1},
    {QLatin1StringView("sine"), Signal::Kind::Sine, 3, 4, 2},
    {QLatin1StringView("noise"), Signal::Kind::Noise, 2, 2, -1},
    {QLatin1StringView("drop"), Signal::Kind::Drop, 4, 4, 2},
    {QLatin1StringView("square"), Signal::Kind::Square, 4, 4, 2},
}};

constexpr qsizetype vaneNumbers = 5;

/// Reads the lines of one file one after another.
class Reader
{
public:
    Reader(const QString &file, const QString &folder, Complaints &complaints)
        : m_file(file)
        , m_folder(folder)
        , m_complaints(complaints)
    {
    }

    void read(const Record &record);
    const SourcePlan &plan() const { return m_plan; }

private:
    void readRate();
    void readRecording();
    void readChannel(const SourceChannel &channel);
    void readSignal(const SourceChannel &channel, const Shape &shape);
    void readVane(const SourceChannel &channel);
    void readOutputSignal(const SourceChannel &channel);
    void readFile(const SourceChannel &channel, bool isIio);
    std::optional<QList<double>> numbers(qsizetype least, qsizetype most, qsizetype positive = -1);
    QString word(qsizetype field) const { return m_record.fields.value(field).text.toLower(); }
    QString path(qsizetype field) const { return QDir(m_folder).absoluteFilePath(m_record.fields.at(field).text); }
    void complain(qsizetype field, const QString &problem);

    QString m_file;
    QString m_folder;
    Complaints &m_complaints;
    Record m_record;
    SourcePlan m_plan;
};

void Reader::complain(qsizetype field, const QString &problem)
{
    m_complaints.add(
        {m_file, m_record.line, static_cast<int>(field) + 1, {}, problem, Text::tr("The line is left out.")});
}

void Reader::read(const Record &record)
{
    m_record = record;
    if (word(0) == u"rate") {
        return readRate();
    }
    if (word(0) == u"record") {
        return readRecording();
    }
    if (const auto channel = channelOf(word(0))) {
        return readChannel(*channel);
    }
    complain(
        0,
        Text::tr("%1 is no channel: a1…a64, f1, d1…d32, p1…p32, v1…v4, o1…o32, rate or record are expected.")
            .arg(quoted(record.fields.constFirst().text)));
}

/// The numbers of the line from the second or third field on. Empty: complained.
std::optional<QList<double>> Reader::numbers(qsizetype least, qsizetype most, qsizetype positive)
{
    const qsizetype first = word(0) == u"rate" ? 1 : 2;
    const qsizetype count = m_record.fields.size() - first;
    if (count < least || count > most) {
        complain(
            m_record.fields.size() - 1,
            Text::tr("%n number(s) are expected here.", nullptr, static_cast<int>(count < least ? least : most)));
        return std::nullopt;
    }
    QList<double> values;
    for (qsizetype i = 0; i < count; ++i) {
        const QString text = m_record.fields.at(first + i).text;
        const auto value = numberOf(text);
        if (!value) {
            complain(first + i, Text::tr("%1 is no number.").arg(quoted(text)));
            return std::nullopt;
        }
        if (i == positive && *value <= 0) {
            complain(first + i, Text::tr("%1 is not greater than 0.").arg(quoted(text)));
            return std::nullopt;
        }
        values.append(*value);
    }
    return values;
}

void Reader::readRate()
{
    if (const auto values = numbers(1, 1, 0)) {
        if (values->constFirst() > SourcePlan::fastest) {
            return complain(1, Text::tr("At most %1 Hz are possible.").arg(SourcePlan::fastest));
        }
        m_plan.rate = values->constFirst();
    }
}

void Reader::readRecording()
{
    if (m_record.fields.size() < 2) {
        return complain(0, Text::tr("The name of the recorded file is missing."));
    }
    if (m_record.fields.size() > 3 || (m_record.fields.size() == 3 && word(2) != u"once")) {
        return complain(2, Text::tr("Only `once` may follow the name of the file."));
    }
    m_plan.recordings.append({path(1), m_record.fields.size() == 2});
}

void Reader::readChannel(const SourceChannel &channel)
{
    const QString kind = word(1);
    if (kind == u"file" || kind == u"iio") {
        return readFile(channel, kind == u"iio");
    }
    if (channel.kind == ChannelKind::Output) {
        return complain(1, Text::tr("An output goes to a file: `file PATH` is expected."));
    }
    if (kind == u"vane" || channel.kind == ChannelKind::Wind) {
        return readVane(channel);
    }
    if (kind == u"output") {
        return readOutputSignal(channel);
    }
    for (const Shape &shape : shapes) {
        if (kind == shape.word) {
            return readSignal(channel, shape);
        }
    }
    complain(
        1,
        Text::tr("%1 is no signal: constant, sine, noise, drop, square, output, vane, iio or file are expected.")
            .arg(quoted(kind)));
}

void Reader::readSignal(const SourceChannel &channel, const Shape &shape)
{
    const auto values = numbers(shape.least, shape.most, shape.positive);
    if (!values) {
        return;
    }
    Signal signal;
    signal.kind = shape.kind;
    signal.level = values->at(0);
    signal.size = values->value(1);
    signal.period = values->value(2, 1);
    signal.extent = values->value(3);
    if (shape.kind == Signal::Kind::Square) {
        signal.size -= signal.level;
    }
    m_plan.signals_.emplace(channel, signal);
}

void Reader::readVane(const SourceChannel &channel)
{
    if (word(1) != u"vane" || channel.kind != ChannelKind::Wind) {
        return complain(1, Text::tr("`vane` and the channels v1…v4 go together."));
    }
    if (const auto values = numbers(vaneNumbers, vaneNumbers, vaneNumbers - 1)) {
        m_plan.vanes[channel.index] = {values->at(0), values->at(1), values->at(2), values->at(3), values->at(4)};
    }
}

void Reader::readOutputSignal(const SourceChannel &channel)
{
    const auto values = numbers(2, 2);
    if (!values) {
        return;
    }
    const double bit = values->at(1);
    if (bit < 0 || bit >= static_cast<double>(mostDigital)) {
        return complain(3, Text::tr("An output has a bit from 0 to 31."));
    }
    m_plan.outputSignals.append({channel, values->at(0), static_cast<int>(bit)});
}

void Reader::readFile(const SourceChannel &channel, bool isIio)
{
    if (channel.kind == ChannelKind::Wind || (isIio && channel.kind != ChannelKind::Analogue)) {
        return complain(1, Text::tr("Such a channel cannot come from there."));
    }
    const qsizetype expected = isIio ? 4 : 3;
    if (m_record.fields.size() != expected) {
        return complain(
            m_record.fields.size() - 1,
            isIio ? Text::tr("`iio FOLDER INPUT` is expected.") : Text::tr("`file PATH` is expected."));
    }
    bool isGood = true;
    const int input = isIio ? m_record.fields.at(3).text.toInt(&isGood) : -1;
    if (!isGood || (isIio && input < 0)) {
        return complain(3, Text::tr("%1 is no input of a device.").arg(quoted(m_record.fields.at(3).text)));
    }
    m_plan.files.append({channel, path(2), input});
}

} // namespace

std::optional<SourceChannel> channelOf(QStringView name)
{
    if (name.isEmpty()) {
        return std::nullopt;
    }
    for (const KindOfChannel &kind : kinds) {
        bool isNumber = false;
        const int number = name.sliced(1).toInt(&isNumber);
        if (name.front().toLower() == kind.letter && isNumber && number >= 1
            && static_cast<std::size_t>(number) <= kind.count) {
            return SourceChannel{kind.kind, number - 1};
        }
    }
    return std::nullopt;
}

SourcePlan readSources(const QString &file, const QByteArray &bytes, const QString &folder, Complaints &complaints)
{
    Reader reader(file, folder, complaints);
    for (const Record &record : recordsOf(decodeStationText(bytes))) {
        reader.read(record);
    }
    return reader.plan();
}

} // namespace gorizont::station
