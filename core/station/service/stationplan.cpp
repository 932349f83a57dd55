#include "core/station/service/stationplan.h"

#include "core/protocol/ackmessages.h"
#include "core/station/service/rawmapping.h"
#include "core/station/stationfolder.h"
#include "core/station/stationtext.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <algorithm>
#include <numeric>

namespace gorizont::station {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 longestFile = 1024 * 1024; ///< bytes
constexpr int inputsOfIio = 64;

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::StationPlan)
};

LineConfig lineOf(const StationObject &object)
{
    LineConfig line;
    line.com = object.com;
    line.device = object.device;
    line.baudRate = object.baudRate;
    line.dataBits = object.dataBits;
    line.parity = object.parity;
    line.stopBits = object.stopBits;
    line.isOn = true;
    return line;
}

void complain(StationPlan &plan, const StationObject &object, const QString &problem, const QString &action)
{
    constexpr int extraField = 8;
    plan.complaints.append({u"ACK.INI"_s, object.line, extraField, Text::tr("extra"), problem, action});
}

/// `T01` as a parameter of ACK.PAR. Empty: there is none.
std::optional<ParameterId> idOf(const QString &text, const StationConfig &config)
{
    bool isNumber = text.size() == 1;
    const int number = isNumber ? 1 : QStringView(text).sliced(1).toInt(&isNumber);
    if (!isNumber) {
        return std::nullopt;
    }
    const int index = config.indexOf({latinised(text.front()), number});
    return index >= 0 ? std::optional(config.parameters.at(index).id()) : std::nullopt;
}

void readIds(const QString &list, const StationObject &object, GatheredObject &gathered, StationPlan &plan)
{
    for (const QString &part : list.split(u',', Qt::SkipEmptyParts)) {
        const QString name = part.trimmed();
        const auto id = name == u"-" ? std::nullopt : idOf(name, plan.config);
        if (!id && name != u"-") {
            complain(
                plan, object, Text::tr("ACK.PAR has no parameter %1.").arg(quoted(name)),
                Text::tr("This value of object %1 is not taken over.").arg(object.number));
        }
        gathered.ids.append(id);
    }
}

GatheredObject gatheredOf(const StationObject &object, StationPlan &plan)
{
    GatheredObject gathered;
    gathered.number = object.number;
    gathered.period = object.period.count() > 0 ? object.period : GatheredObject::usualPeriod;
    gathered.line = lineOf(object);
    QString list = object.extra;
    if (const qsizetype colon = list.indexOf(u':'); colon >= 0 || (list.size() == 1 && list.front().isDigit())) {
        bool isNumber = false;
        const int command = (colon >= 0 ? list.first(colon) : list).toInt(&isNumber);
        if (isNumber && ack::valuesPerParameter(command) > 0) {
            gathered.command = command;
        } else {
            complain(
                plan, object, Text::tr("%1 is no data command, 1 to 8.").arg(quoted(list)),
                Text::tr("Object %1 is asked with command %2.").arg(object.number).arg(gathered.command));
        }
        list = colon >= 0 ? list.sliced(colon + 1) : QString();
    }
    readIds(list, object, gathered, plan);
    return gathered;
}

/// `w:file:RECORDING` and `w:iio:FOLDER`: the source of a board without ACK.SRC.
void addBoardSource(const StationObject &object, const QString &folder, int firstChannel, StationPlan &plan)
{
    const qsizetype colon = object.device.indexOf(u':');
    const QString kind = object.device.first(std::max<qsizetype>(colon, 0)).toLower();
    const QString path = QDir(folder).absoluteFilePath(object.device.sliced(colon + 1));
    if (kind == u"file") {
        plan.sources.recordings.append({path, true});
    } else if (kind == u"iio") {
        for (int input = 0; input < inputsOfIio - firstChannel; ++input) {
            if (QFile::exists(path + u"/in_voltage%1_raw"_s.arg(input))) {
                plan.sources.files.append({{ChannelKind::Analogue, firstChannel + input}, path, input});
            }
        }
    } else if (!object.device.isEmpty()) {
        complain(
            plan, object, Text::tr("%1 is no source: file:NAME or iio:FOLDER are.").arg(quoted(object.device)),
            Text::tr("Only ACK.SRC gives values to this board."));
    }
}

QList<int> parametersOf(const QList<BoardConfig> &boards, ObjectKind kind, const StationConfig &config)
{
    QList<int> indices;
    const auto append = [&](const ParameterId &id) {
        if (const int index = config.indexOf(id); index >= 0 && !indices.contains(index)) {
            indices.append(index);
        }
    };
    for (const BoardConfig &board : boards) {
        if ((board.kind == BoardKind::L154) != (kind == ObjectKind::L154)) {
            continue;
        }
        for (const BoardInput &input : board.analogue) {
            append(input.parameter);
        }
        if (board.frequency) {
            append(*board.frequency);
        }
        for (const BoardInput &input : board.digital) {
            append(input.parameter);
        }
    }
    return indices;
}

/// What the n-th wind sensor measures: An and Mn.
QList<int> windParameters(int number, const StationConfig &config)
{
    QList<int> indices;
    for (const QChar code : {weathercode::windDirection, weathercode::windSpeed}) {
        if (const int index = config.indexOf({code, number}); index >= 0) {
            indices.append(index);
        }
    }
    return indices;
}

/// The records of \a object, together with those of an earlier line that has the same number.
void addRecords(const StationObject &object, int wind, StationPlan &plan)
{
    const StationConfig &config = plan.config;
    auto known = std::find_if(plan.records.begin(), plan.records.end(), [&](const RecordedObject &recorded) {
        return recorded.number == object.number;
    });
    if (known == plan.records.end()) {
        plan.records.append({object.number, object.period, {}, object.isPolled(config.settings.number)});
        known = std::prev(plan.records.end());
    }
    known->period = std::min(known->period, object.period);
    if (object.number == config.settings.number) {
        known->parameters.resize(config.parameters.size());
        std::iota(known->parameters.begin(), known->parameters.end(), 0);
        return;
    }
    const QList<int> more = object.kind == ObjectKind::Wind ? windParameters(wind, config)
                                                            : parametersOf(config.boards, object.kind, config);
    for (const int index : more) {
        if (!known->parameters.contains(index)) {
            known->parameters.append(index);
        }
    }
}

QByteArray readSourceFile(const QString &folder)
{
    for (const QString &name : QDir(folder).entryList(QDir::Files, QDir::Name)) {
        QFile file(QDir(folder).filePath(name));
        if (latinised(name.toUpper()) == sourceFileName && file.open(QIODevice::ReadOnly)) {
            return file.read(longestFile);
        }
    }
    return {};
}

} // namespace

StationPlan planOf(const StationConfig &config, const SourcePlan &sources, const QString &folder)
{
    StationPlan plan;
    plan.config = config;
    plan.sources = sources;
    int wind = 0;
    for (const StationObject &object : config.objects) {
        wind += object.kind == ObjectKind::Wind ? 1 : 0;
        if (object.isDispatcher(config.settings.number)) {
            plan.dispatchers.append({lineOf(object), object.device.startsWith(u"tcp://"_s, Qt::CaseInsensitive)});
        } else if (object.isPolled(config.settings.number)) {
            plan.gathered.append(gatheredOf(object, plan));
        } else if (object.kind == ObjectKind::L154 || object.kind == ObjectKind::Fastwel) {
            addBoardSource(object, folder, firstChannelOf(config, object.kind), plan);
        }
        if (object.period.count() > 0 && !object.isDispatcher(config.settings.number)) {
            addRecords(object, wind, plan);
        }
    }
    return plan;
}

StationPlan readPlan(const QString &folder)
{
    const StationReading reading = readStationIn(folder);
    Complaints complaints;
    const SourcePlan sources = readSources(sourceFileName, readSourceFile(folder), folder, complaints);
    StationPlan plan = planOf(reading.config, sources, folder);
    plan.complaints = reading.complaints + complaints.list() + plan.complaints;
    return plan;
}

} // namespace gorizont::station
