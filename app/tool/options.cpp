#include "app/tool/options.h"

#include "app/tool/text.h"
#include "app/tool/usage.h"
#include "core/devices/ind3/ind3values.h"

#include <QCommandLineParser>
#include <QDir>
#include <QRegularExpression>
#include <QUrl>

#include <cmath>
#include <limits>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

constexpr int mostMilliseconds = 3'600'000;

/// Reads the values one after the other and keeps the first thing that is wrong, as a sentence.
class Reader
{
public:
    explicit Reader(const QCommandLineParser &parser)
        : m_parser(parser)
    {
    }

    std::optional<Options> read()
    {
        readCommand();
        readLine();
        readSensor();
        readCommandOptions();
        readArguments();
        return m_problem.isEmpty() ? std::optional(m_options) : std::nullopt;
    }
    QString problem() const { return m_problem; }

private:
    void complain(const QString &problem)
    {
        if (m_problem.isEmpty()) {
            m_problem = problem;
        }
    }
    void complainOf(const QString &option, const QString &range)
    {
        complain(Text::tr("--%1 takes %2, not \"%3\"").arg(option, range, m_parser.value(option)));
    }

    std::optional<int> number(const QString &option, int least, int most)
    {
        if (!m_parser.isSet(option)) {
            return std::nullopt;
        }
        bool isNumber = false;
        const int value = m_parser.value(option).toInt(&isNumber);
        if (!isNumber || value < least || value > most) {
            complainOf(option, u"%1…%2"_s.arg(least).arg(most));
            return std::nullopt;
        }
        return value;
    }

    /// One of \a names; \a values stand in the same order. \a fallback if the option is not there.
    template <typename T> T choice(const QString &option, const QStringList &names, const QList<T> &values, T fallback)
    {
        if (!m_parser.isSet(option)) {
            return fallback;
        }
        const qsizetype at = names.indexOf(m_parser.value(option).toLower());
        if (at < 0) {
            complainOf(option, names.join(u", "_s));
            return fallback;
        }
        return values.at(at);
    }

    std::optional<double> arcSeconds(QString text)
    {
        text.replace(u',', u'.').replace(QChar(0x2212), u'-');
        bool isNumber = false;
        const double value = text.toDouble(&isNumber);
        return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

    void readCommand()
    {
        const QStringList words = m_parser.positionalArguments();
        if (words.isEmpty()) {
            return complain(Text::tr("a command is missing; --help lists them"));
        }
        const qsizetype nameWords = words.constFirst() == u"usm" && words.size() > 1 ? 2 : 1;
        const QString name = words.first(nameWords).join(u' ');
        m_options.command = commandNamed(name);
        if (!m_options.command) {
            return complain(Text::tr("there is no command \"%1\"; --help lists them").arg(name));
        }
        const Command &command = *m_options.command;
        m_arguments = words.sliced(nameWords);
        if (m_arguments.size() != command.argumentCount()) {
            const QString needed = command.arguments.isEmpty() ? Text::tr("nothing") : command.arguments;
            complain(Text::tr("after %1 comes %2").arg(command.name, needed));
        }
        const QStringList special = commandOptions();
        for (const QString &option : special) {
            if (m_parser.isSet(option) && !command.options.contains(option)) {
                complain(Text::tr("%1 does not take --%2").arg(command.name, option));
            }
        }
    }

    void readLine()
    {
        LineConfig &line = m_options.line;
        readDevice(m_parser.value(u"device"_s));
        line.baudRate = number(u"baud"_s, 50, 4'000'000).value_or(line.baudRate);
        line.parity = choice(
            u"parity"_s, {u"none"_s, u"even"_s, u"odd"_s, u"mark"_s, u"space"_s},
            {Parity::None, Parity::Even, Parity::Odd, Parity::Mark, Parity::Space}, Parity::None);
        line.stopBits = choice(
            u"stop-bits"_s, {u"1"_s, u"1.5"_s, u"2"_s}, {StopBits::One, StopBits::OneAndHalf, StopBits::Two},
            StopBits::One);
        line.isRs485 = m_parser.isSet(u"rs485"_s);
        m_options.timing.readCommand =
            std::chrono::milliseconds(number(u"timeout"_s, 1, mostMilliseconds).value_or(200));
        m_options.isJson = m_parser.isSet(u"json"_s);
        m_options.isYes = m_parser.isSet(u"yes"_s);
    }

    void readDevice(const QString &device)
    {
        static const QRegularExpression numbered(
            u"^com([1-9][0-9]{0,3})$"_s, QRegularExpression::CaseInsensitiveOption);
        if (device.isEmpty()) {
            return complain(Text::tr("--device is missing"));
        }
        if (const auto match = numbered.match(device); match.hasMatch()) {
            m_options.line.com = match.captured(1).toInt();
            return;
        }
        m_options.line.device = device;
        if (device.startsWith(u"tcp://"_s, Qt::CaseInsensitive)) {
            const QUrl url(device);
            if (url.host().isEmpty() || url.port(0) < 1) {
                complainOf(u"device"_s, u"tcp://HOST:PORT"_s);
            }
        } else if (device.startsWith(u"sim:"_s, Qt::CaseInsensitive)) {
            complainOf(u"device"_s, u"PATH, COMn, tcp://HOST:PORT"_s);
        } else if (device.contains(u'/') || device.contains(u'\\')) {
            m_options.line.device = QDir(device).absolutePath(); // a relative name means one below /dev
        }
    }

    void readSensor()
    {
        const Command *command = m_options.command;
        if (!command) {
            return;
        }
        const Device fallback = command->runInd3 ? Device::Ind3 : command->runAnd3 ? Device::And3 : Device::Usm;
        if (command->runInd3 && command->runAnd3 && !m_parser.isSet(u"type"_s)) {
            complain(Text::tr("--type is missing"));
        }
        if (command->runUsm && m_parser.isSet(u"type"_s)) {
            complain(Text::tr("%1 does not take --%2").arg(command->name, u"type"_s));
        }
        m_options.device = choice(u"type"_s, {u"ind3"_s, u"and3"_s}, {Device::Ind3, Device::And3}, fallback);
        if (!command->runOf(m_options.device)) {
            complain(Text::tr("%1 does not have the command %2").arg(m_parser.value(u"type"_s), command->name));
        }
        using ind3::Dialect;
        m_options.dialect = choice(
            u"protocol"_s, {u"2.11"_s, u"2.10"_s, u"modbus"_s}, {Dialect::V211, Dialect::V210, Dialect::Modbus},
            Dialect::V211);
        if (m_options.device != Device::Ind3 && m_parser.isSet(u"protocol"_s)) {
            complain(Text::tr("only ind3 has a --protocol"));
        }
        m_options.address = number(u"address"_s, 1, 255).value_or(0);
        if (command->needsAddress && m_options.address == 0) {
            complain(Text::tr("--address is missing"));
        } else if (!command->needsAddress && m_options.address != 0) {
            complain(Text::tr("%1 does not take --%2").arg(command->name, u"address"_s));
        }
        const bool hasSettings = m_options.device != Device::Ind3 || m_options.dialect != Dialect::V210;
        if (!hasSettings && command->name != u"scan" && command->name != u"read") {
            complain(Text::tr("protocol 2.10 has no settings: only scan and read"));
        }
    }

    void readCommandOptions()
    {
        m_options.from = number(u"from"_s, 1, 255).value_or(1);
        m_options.to = number(u"to"_s, 1, 255).value_or(255);
        if (m_options.from > m_options.to) {
            complain(Text::tr("--from is after --to"));
        }
        m_options.count = number(u"count"_s, 0, std::numeric_limits<int>::max()).value_or(1);
        m_options.interval = std::chrono::milliseconds(number(u"interval"_s, 0, mostMilliseconds).value_or(1000));
        if (const QString ticks = u"ticks"_s; m_parser.isSet(ticks)) {
            m_options.ticks = choice<int>(
                ticks, {u"1"_s, u"2"_s, u"4"_s, u"8"_s, u"16"_s, u"32"_s, u"64"_s}, {1, 2, 4, 8, 16, 32, 64}, 0);
        }
        if (const QString period = u"period"_s;
            m_parser.isSet(period) && !(m_options.command && m_options.command->runUsm)) {
            m_options.period = std::chrono::milliseconds(
                choice<int>(period, {u"10"_s, u"20"_s, u"50"_s, u"100"_s}, {10, 20, 50, 100}, 0));
        }
        if (m_options.command && m_options.command->options.contains(u"ticks"_s) && !m_options.ticks
            && !m_options.period) {
            complain(Text::tr("--ticks or --period is missing"));
        }
    }

    void readArguments()
    {
        if (!m_problem.isEmpty()) {
            return;
        }
        const QString name = m_options.command->name;
        if (m_options.command->runUsm) {
            if (const QString problem = readUsmOptions(m_parser, name, m_arguments, m_options.usm);
                !problem.isEmpty()) {
                complain(problem);
            }
        } else if (name == u"set-address") {
            bool isNumber = false;
            m_options.newAddress = m_arguments.at(0).toInt(&isNumber);
            if (!isNumber || !ind3::isAddress(m_options.newAddress)) {
                complain(Text::tr("an address is 1…255, not \"%1\"").arg(m_arguments.at(0)));
            }
        } else if (name == u"set-name") {
            readName();
        } else if (name == u"set-offset") {
            readOffset();
        }
    }

    void readName()
    {
        m_options.name = m_arguments.at(0);
        if (m_options.name.startsWith(QChar(0x2212))) {
            m_options.name[0] = u'-';
        }
        if (m_options.dialect == ind3::Dialect::Modbus) {
            complain(Text::tr("there is no name in Modbus"));
        } else if (!ind3::encodeName(m_options.name)) {
            complain(Text::tr("a name has 1…16 characters of Windows-1251: \"%1\" does not").arg(m_options.name));
        }
    }

    void readOffset()
    {
        const auto x = arcSeconds(m_arguments.at(0));
        const auto y = arcSeconds(m_arguments.at(1));
        if (!x || !y || !ind3::encodeAngleBlock({*x, *y})) {
            complain(Text::tr("an offset is two numbers of arc-seconds, not \"%1\"").arg(m_arguments.join(u' ')));
            return;
        }
        m_options.offset = {*x, *y};
    }

    const QCommandLineParser &m_parser;
    QStringList m_arguments;
    Options m_options;
    QString m_problem;
};

} // namespace

std::variant<Options, LastWords> parseOptions(const QStringList &arguments)
{
    QCommandLineParser parser;
    describeUsage(parser);
    if (!parser.parse(withNumbersProtected(arguments))) {
        return LastWords{ExitUsage, parser.errorText()};
    }
    if (parser.isSet(u"help"_s)) {
        return LastWords{ExitGood, parser.helpText()};
    }
    if (parser.isSet(u"version"_s)) {
        return LastWords{ExitGood, u"gorizont-tool " GORIZONT_VERSION ""_s};
    }
    const QString language = parser.value(u"lang"_s);
    if (parser.isSet(u"lang"_s) && language != u"ru" && language != u"en") {
        return LastWords{ExitUsage, Text::tr("--%1 takes %2, not \"%3\"").arg(u"lang"_s, u"ru, en"_s, language)};
    }
    Reader reader(parser);
    const auto options = reader.read();
    return options ? std::variant<Options, LastWords>(*options) : LastWords{ExitUsage, reader.problem()};
}

QString languageArgument(const QStringList &arguments)
{
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        if (arguments.at(i) == u"--lang" && i + 1 < arguments.size()) {
            return arguments.at(i + 1);
        }
        if (arguments.at(i).startsWith(u"--lang="_s)) {
            return arguments.at(i).section(u'=', 1);
        }
    }
    return {};
}

} // namespace gorizont::tool
