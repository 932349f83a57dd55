#include "app/tool/mk14program.h"

#include "app/tool/interruption.h"
#include "app/tool/mk14options.h"
#include "app/tool/mk14text.h"
#include "app/tool/output.h"
#include "app/tool/session.h"
#include "app/tool/subprogram.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "core/devices/mk14/mk14service.h"
#include "core/line/openline.h"
#include "core/values/weatherjson.h"

#include <QCommandLineParser>
#include <QDateTime>
#include <QFile>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr qint64 longestFile = 64 * 1024; ///< bytes; a station takes no longer one

/// One run of a command on an open line.
class Mk14
{
public:
    Mk14(const Mk14Options &options, Line &line)
        : m_options(options)
        , m_line(line)
        , m_service(options.station, options.timing)
    {
    }

    ExitCode run()
    {
        switch (m_options.command) {
        case Mk14Options::Command::Read: return read();
        case Mk14Options::Command::SetTime: return setTime();
        case Mk14Options::Command::SetOutputs: return setOutputs();
        case Mk14Options::Command::SendFile: return sendFile();
        }
        return ExitUsage;
    }

    ExitCode fail(Fault fault, const QString &sentence, QJsonObject failed) const
    {
        complain(u"%1, %2: %3"_s.arg(device()).arg(m_options.address).arg(sentence));
        if (m_options.isJson) {
            failed.insert(u"fault"_s, faultName(fault));
            print(failed);
        }
        return exitCodeOf(fault);
    }

    QJsonObject object() const
    {
        return {{u"type"_s, u"MK-14"_s}, {u"device"_s, device()}, {u"address"_s, m_options.address}};
    }

private:
    QString device() const { return deviceName(m_options.line, {}); }

    QJsonObject outcome(const QString &setting, bool isDone) const
    {
        QJsonObject found = object();
        found.insert(u"setting"_s, setting);
        found.insert(u"done"_s, isDone);
        return found;
    }

    ExitCode notDone(const QString &setting, Fault fault) const
    {
        const bool isSilence = fault == Fault::Timeout || fault == Fault::Checksum || fault == Fault::BadReply;
        const QString sentence = isSilence ? Text::tr("not confirmed (%1)").arg(faultText(fault)) : faultText(fault);
        return fail(fault, sentence, outcome(setting, false));
    }

    ExitCode notAgreed(const QString &setting) const
    {
        return fail(
            Fault::Cancelled, Text::tr("nothing was written. --yes writes without asking"), outcome(setting, false));
    }

    void tell(const QString &text, const QJsonObject &found) const
    {
        if (m_options.isJson) {
            print(found);
        } else {
            print(text);
        }
    }

    bool isAgreed(const QString &question) const
    {
        return m_options.isYes || (isInputTerminal() && askYesNo(question, [this] { return m_line.isInterrupted(); }));
    }

    ExitCode read()
    {
        const auto weather = m_service.read(m_line, m_options.address, m_options.dataCommand);
        QJsonObject found = object();
        found.insert(u"cmd"_s, m_options.dataCommand);
        if (!weather) {
            return fail(weather.fault(), faultText(weather.fault()), found);
        }
        insertWeather(found, *weather);
        tell(textOf(*weather), found);
        return ExitGood;
    }

    ExitCode setTime()
    {
        const QString setting = u"time"_s;
        if (!isAgreed(Text::tr("Set the clock of station %1?").arg(m_options.address))) {
            return notAgreed(setting);
        }
        const auto sent = m_service.setTime(m_line, m_options.address);
        if (!sent) {
            return notDone(setting, sent.fault());
        }
        QJsonObject found = outcome(setting, true);
        found.insert(u"time"_s, *sent);
        const QString shown = QDateTime::fromSecsSinceEpoch(*sent, Qt::UTC).toString(u"yyyy-MM-dd hh:mm:ss"_s);
        tell(Text::tr("The clock of the station shows %1.").arg(shown), found);
        return ExitGood;
    }

    ExitCode setOutputs()
    {
        const QString setting = u"outputs"_s;
        const QString word = u"0x%1"_s.arg(m_options.word, 8, 16, QLatin1Char('0'));
        if (!isAgreed(Text::tr("Give the outputs of station %1 the word %2?").arg(m_options.address).arg(word))) {
            return notAgreed(setting);
        }
        const auto weather = m_service.setOutputs(m_line, m_options.address, m_options.word);
        if (!weather) {
            return notDone(setting, weather.fault());
        }
        QJsonObject found = outcome(setting, true);
        found.insert(u"outputs"_s, qint64(m_options.word));
        found.insert(u"digital"_s, qint64(weather->digital));
        tell(
            Text::tr("The outputs have the word %1. A server that polls the station must have it as Outputs{i} too.")
                .arg(word),
            found);
        return ExitGood;
    }

    ExitCode sendFile()
    {
        const QString setting = u"file"_s;
        QFile file(m_options.file);
        const QByteArray text = file.open(QIODevice::ReadOnly) ? file.read(longestFile + 1) : QByteArray();
        if (!file.isOpen() || text.size() > longestFile) {
            return fail(
                Fault::Refused,
                u"%1: %2"_s.arg(m_options.file, file.isOpen() ? Text::tr("longer than 64 KiB") : file.errorString()),
                outcome(setting, false));
        }
        const QString question = Text::tr("Send %1 to station %2?").arg(m_options.name).arg(m_options.address);
        if (!isAgreed(question)) {
            return notAgreed(setting);
        }
        const auto sent = m_service.sendFile(m_line, m_options.address, m_options.name.toUtf8(), text);
        if (!sent) {
            return notDone(setting, sent.fault());
        }
        QJsonObject found = outcome(setting, true);
        found.insert(u"file"_s, m_options.file);
        found.insert(u"name"_s, m_options.name);
        tell(Text::tr("The station has %1.").arg(m_options.name), found);
        return ExitGood;
    }

    const Mk14Options &m_options;
    Line &m_line;
    mk14::Service m_service;
};

} // namespace

ExitCode runMk14(const QStringList &arguments)
{
    QCommandLineParser parser;
    describeMk14(parser);
    if (const auto ended = parseSubprogram(parser, u"mk14"_s, arguments)) {
        return *ended;
    }
    const auto options = mk14Options(parser);
    if (const auto *problem = std::get_if<QString>(&options)) {
        complain(*problem);
        return ExitUsage;
    }
    const Mk14Options &good = std::get<Mk14Options>(options);
    const auto line = makeLine(good.line, {}, good.timing.pauseTick);
    const Interruption interruption(*line);
    Mk14 mk14(good, *line);
    if (const auto opened = line->open(); !opened) {
        return mk14.fail(opened.fault(), line->lastError().text, mk14.object());
    }
    return mk14.run();
}

} // namespace gorizont::tool
