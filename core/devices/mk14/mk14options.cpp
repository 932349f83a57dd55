#include "core/devices/mk14/mk14options.h"

#include "core/protocol/ackmessages.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>

namespace gorizont::mk14 {

namespace {

class OptionText
{
    Q_DECLARE_TR_FUNCTIONS(Mk14Driver)
};

/// One complaint about the key \a key of \a sensor.
QString complaint(const SensorConfig &sensor, const char *key, const QString &takes)
{
    const QString value = sensor.options.value(QString::fromLatin1(key).toLower()).trimmed();
    return OptionText::tr("%1%2 is \"%3\", but takes %4. Its usual value is used.")
        .arg(QString::fromLatin1(key))
        .arg(sensor.index)
        .arg(value, takes);
}

QString valueOf(const SensorConfig &sensor, const char *key)
{
    return sensor.options.value(QString::fromLatin1(key).toLower()).trimmed();
}

void readCommands(const SensorConfig &sensor, Options &options)
{
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    QList<int> commands;
    bool isGood = true;
    for (const QString &word : valueOf(sensor, "Cmd").split(separators, Qt::SkipEmptyParts)) {
        const int command = word.toInt();
        isGood = isGood && command >= ack::firstDataCommand && command <= ack::lastDataCommand;
        commands.append(command);
    }
    if (!isGood) {
        options.complaints.append(complaint(sensor, "Cmd", OptionText::tr("numbers from 1 to 8, like 8,4")));
    } else if (!commands.isEmpty()) {
        options.commands = commands;
    }
}

void readOutputs(const SensorConfig &sensor, Options &options)
{
    const QString text = valueOf(sensor, "Outputs");
    if (text.isEmpty()) {
        return;
    }
    if (const auto word = outputWord(text)) {
        options.outputs = *word;
    } else {
        options.complaints.append(
            complaint(sensor, "Outputs", OptionText::tr("a number of at most 32 bits, like 5 or 0x0005")));
    }
}

void readClock(const SensorConfig &sensor, Options &options)
{
    const QString text = valueOf(sensor, "StationClock");
    options.isClockUtc = text.compare(u"UTC", Qt::CaseInsensitive) == 0;
    if (!text.isEmpty() && !options.isClockUtc && text.compare(u"local", Qt::CaseInsensitive) != 0) {
        options.complaints.append(complaint(sensor, "StationClock", QStringLiteral("UTC, local")));
    }
}

void readList(const SensorConfig &sensor, Options &options)
{
    const QString text = valueOf(sensor, "Params");
    options.parameters = usualParameters();
    if (text.isEmpty()) {
        return;
    }
    if (const auto parameters = parametersInList(text)) {
        options.parameters = *parameters;
    } else {
        options.complaints.append(complaint(sensor, "Params", OptionText::tr("letters, like U,T,P,H,A,M")));
    }
}

/// Whether there is a file with at least one parameter.
bool readFile(const SensorConfig &sensor, Options &options)
{
    const QString path = valueOf(sensor, "ParFile");
    if (path.isEmpty()) {
        return false;
    }
    QFile disk(path);
    if (!disk.open(QIODevice::ReadOnly)) {
        options.complaints.append(
            OptionText::tr("ParFile%1: %2: %3. Params%1 is used.").arg(sensor.index).arg(path, disk.errorString()));
        return false;
    }
    const ParameterFile file = parametersInFile(disk.read(longestParameterFile));
    for (const int line : file.badLines) {
        options.complaints.append(OptionText::tr("ParFile%1: %2, line %3: name, unit, short name, code (a letter) and "
                                                 "number are expected. The line is left out.")
                                      .arg(sensor.index)
                                      .arg(path)
                                      .arg(line));
    }
    if (file.parameters.isEmpty()) {
        options.complaints.append(
            OptionText::tr("ParFile%1: %2 has no parameter. Params%1 is used.").arg(sensor.index).arg(path));
        return false;
    }
    options.parameters = file.parameters;
    return true;
}

} // namespace

std::optional<quint32> outputWord(const QString &text)
{
    bool isNumber = false;
    const bool isHex = text.startsWith(u"0x", Qt::CaseInsensitive);
    const quint32 word = isHex ? text.mid(2).toUInt(&isNumber, 16) : text.toUInt(&isNumber, 10);
    return isNumber ? std::optional(word) : std::nullopt;
}

Options Options::from(const SensorConfig &sensor)
{
    Options options;
    readCommands(sensor, options);
    readOutputs(sensor, options);
    readClock(sensor, options);
    if (!readFile(sensor, options)) {
        readList(sensor, options);
    }
    return options;
}

} // namespace gorizont::mk14
