#include "app/tool/vimsprogram.h"

#include "app/tool/interruption.h"
#include "app/tool/output.h"
#include "app/tool/session.h"
#include "app/tool/subprogram.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "app/tool/vimsoptions.h"
#include "app/tool/vimstext.h"
#include "core/devices/lvims/lvimsfiles.h"
#include "core/line/openline.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QSaveFile>

#include <thread>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

using namespace lvims;

/// One run of a command on an open line.
class Vims
{
public:
    Vims(const VimsOptions &options, Line &line)
        : m_options(options)
        , m_line(line)
        , m_service(options.address, options.timing)
    {
    }

    ExitCode run()
    {
        switch (m_options.command) {
        case VimsOptions::Command::Info: return info();
        case VimsOptions::Command::State: return state();
        case VimsOptions::Command::Waveform:
        case VimsOptions::Command::Spectrum: return capture();
        case VimsOptions::Command::Settings: return m_options.saveTo.isEmpty() ? load() : save();
        }
        return ExitUsage;
    }

    ExitCode fail(Fault fault, const QString &sentence, QJsonObject more = {}) const
    {
        showProgress({});
        complain(u"%1: %2"_s.arg(m_options.line.device, sentence));
        if (m_options.isJson) {
            QJsonObject failed = object();
            failed.insert(u"fault"_s, faultName(fault));
            for (auto it = more.constBegin(); it != more.constEnd(); ++it) {
                failed.insert(it.key(), it.value());
            }
            print(failed);
        }
        return exitCodeOf(fault);
    }

private:
    QJsonObject object() const { return {{u"type"_s, u"L-VIMS"_s}, {u"device"_s, m_options.line.device}}; }

    ExitCode fail(Fault fault) const { return fail(fault, faultText(fault)); }

    void tell(const QString &text, const QJsonObject &found) const
    {
        showProgress({});
        if (m_options.isJson) {
            print(found);
        } else {
            print(text);
        }
    }

    ExitCode info()
    {
        const auto identity = m_service.identity(m_line);
        if (!identity) {
            return fail(identity.fault());
        }
        QJsonObject found = object();
        insertIdentity(found, *identity);
        tell(textOf(*identity), found);
        return ExitGood;
    }

    ExitCode state()
    {
        const auto vibration = m_service.state(m_line);
        if (!vibration) {
            return fail(vibration.fault());
        }
        QJsonObject found = object();
        insertVibration(found, *vibration);
        tell(textOf(*vibration), found);
        return ExitGood;
    }

    Result<Capture> fetched() const
    {
        Capture capture = m_service.capture(m_options.kind, m_options.channel);
        while (!capture.isDone()) {
            if (const auto done = capture.step(m_line, std::chrono::steady_clock::now()); !done) {
                return done.fault();
            }
            if (!capture.codes().isEmpty()) {
                showProgress(Text::tr("%1 of %2").arg(capture.codes().size()).arg(capture.information().size));
            }
            std::this_thread::sleep_for(capture.pause());
        }
        return capture;
    }

    QByteArray fileOf(const Capture &capture) const
    {
        const bool isWaveform = m_options.command == VimsOptions::Command::Waveform;
        const bool isSound = QFileInfo(m_options.out).suffix().compare(u"wav", Qt::CaseInsensitive) == 0;
        const auto &format = isWaveform ? (isSound ? waveformWav : waveformCsv) : spectrumCsv;
        return format(capture.information(), capture.codes());
    }

    ExitCode capture()
    {
        const auto capture = fetched();
        if (!capture) {
            return fail(capture.fault());
        }
        if (!m_options.out.isEmpty()) {
            if (const QString problem = write(m_options.out, fileOf(*capture)); !problem.isEmpty()) {
                return fail(Fault::Refused, problem);
            }
        }
        QJsonObject found = object();
        insertCapture(found, *capture, m_options.kind);
        found.insert(u"file"_s, m_options.out.isEmpty() ? QJsonValue(QJsonValue::Null) : QJsonValue(m_options.out));
        tell(textOf(*capture, m_options.kind), found);
        return ExitGood;
    }

    ExitCode save()
    {
        const auto identity = m_service.identity(m_line);
        if (!identity) {
            return fail(identity.fault());
        }
        const auto set = m_service.settings(m_line, moduleRegister("CUR_SETTINGS"));
        if (!set) {
            return fail(set.fault());
        }
        const QString problem = write(m_options.saveTo, settingsFile(*identity, set->values()));
        if (!problem.isEmpty()) {
            return fail(Fault::Refused, problem);
        }
        QJsonObject found = object();
        found.insert(u"setting"_s, u"settings"_s);
        found.insert(u"done"_s, true);
        found.insert(u"file"_s, m_options.saveTo);
        tell(Text::tr("The settings are in %1.").arg(m_options.saveTo), found);
        return ExitGood;
    }

    ExitCode load()
    {
        QFile file(m_options.loadFrom);
        const auto values = file.open(QIODevice::ReadOnly) ? settingsIn(file.readAll()) : std::nullopt;
        if (!values) {
            complain(Text::tr("%1 is no file of settings").arg(m_options.loadFrom));
            return ExitUsage;
        }
        if (!isAgreed()) {
            return fail(Fault::Cancelled, Text::tr("nothing was written. --yes writes without asking"));
        }
        const auto done = m_service.restoreSettings(m_line, *values, m_options.toFlash);
        QJsonObject outcome{{u"setting"_s, u"settings"_s}, {u"done"_s, bool(done)}, {u"file"_s, m_options.loadFrom}};
        insertErrors(outcome, m_service.errors());
        if (!done) {
            return fail(done.fault(), textOf(m_service.errors(), done.fault()), outcome);
        }
        QJsonObject found = object();
        for (auto it = outcome.constBegin(); it != outcome.constEnd(); ++it) {
            found.insert(it.key(), it.value());
        }
        tell(Text::tr("The module uses the settings of %1.").arg(m_options.loadFrom), found);
        return ExitGood;
    }

    bool isAgreed() const
    {
        const QString question = Text::tr("All settings of the module change, its network address too. Write them?");
        return m_options.isYes || (isInputTerminal() && askYesNo(question, [this] { return m_line.isInterrupted(); }));
    }

    /// Empty: done.
    static QString write(const QString &path, const QByteArray &bytes)
    {
        QSaveFile file(path);
        const bool isDone = file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
        return isDone ? QString() : u"%1: %2"_s.arg(path, file.errorString());
    }

    const VimsOptions &m_options;
    Line &m_line;
    Service m_service;
};

} // namespace

ExitCode runVims(const QStringList &arguments)
{
    QCommandLineParser parser;
    describeVims(parser);
    if (const auto ended = parseSubprogram(parser, u"vims"_s, arguments)) {
        return *ended;
    }
    const auto options = vimsOptions(parser);
    if (const auto *problem = std::get_if<QString>(&options)) {
        complain(*problem);
        return ExitUsage;
    }
    const VimsOptions &good = std::get<VimsOptions>(options);
    const auto line = makeLine(good.line, {}, good.timing.pauseTick);
    const Interruption interruption(*line);
    Vims vims(good, *line);
    if (const auto opened = line->open(); !opened) {
        return vims.fail(opened.fault(), line->lastError().text);
    }
    return vims.run();
}

} // namespace gorizont::tool
