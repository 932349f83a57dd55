#include "app/tool/vimsprogram.h"

#include "app/tool/interruption.h"
#include "app/tool/output.h"
#include "app/tool/subprogram.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "app/tool/vimssettings.h"
#include "app/tool/vimstext.h"
#include "core/devices/lvims/lvimsfiles.h"
#include "core/files/wholefile.h"
#include "core/line/openline.h"

#include <QCommandLineParser>
#include <QFileInfo>

#include <thread>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

using namespace lvims;

/// The commands that change nothing.
class Vims
{
public:
    explicit Vims(const VimsRun &run)
        : m_run(run)
        , m_options(run.options())
        , m_line(run.line())
        , m_service(m_options.address, m_options.timing)
    {
    }

    ExitCode info()
    {
        const auto identity = m_service.identity(m_line);
        if (!identity) {
            return m_run.fail(identity.fault());
        }
        QJsonObject found = m_run.object();
        insertIdentity(found, *identity);
        m_run.tell(textOf(*identity), found);
        return ExitGood;
    }

    ExitCode state()
    {
        const auto vibration = m_service.state(m_line);
        if (!vibration) {
            return m_run.fail(vibration.fault());
        }
        QJsonObject found = m_run.object();
        insertVibration(found, *vibration);
        m_run.tell(textOf(*vibration), found);
        return ExitGood;
    }

    ExitCode capture()
    {
        const auto capture = fetched();
        if (!capture) {
            return m_run.fail(capture.fault());
        }
        if (!m_options.out.isEmpty()) {
            if (const QString problem = writeWholeFile(m_options.out, fileOf(*capture)); !problem.isEmpty()) {
                return m_run.fail(Fault::Refused, problem);
            }
        }
        QJsonObject found = m_run.object();
        insertCapture(found, *capture, m_options.kind);
        found.insert(u"file"_s, m_options.out.isEmpty() ? QJsonValue(QJsonValue::Null) : QJsonValue(m_options.out));
        m_run.tell(textOf(*capture, m_options.kind), found);
        return ExitGood;
    }

private:
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

    const VimsRun &m_run;
    const VimsOptions &m_options;
    Line &m_line;
    Service m_service;
};

ExitCode runOn(const VimsRun &run)
{
    using Command = VimsOptions::Command;
    switch (run.options().command) {
    case Command::Info: return Vims(run).info();
    case Command::State: return Vims(run).state();
    case Command::Waveform:
    case Command::Spectrum: return Vims(run).capture();
    case Command::Settings: return VimsSettings(run).settings();
    case Command::Reload: return VimsSettings(run).reload();
    case Command::Reboot: return VimsSettings(run).reboot();
    }
    return ExitUsage;
}

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
    const VimsRun run(good, *line);
    if (const auto opened = line->open(); !opened) {
        return run.fail(opened.fault(), line->lastError().text);
    }
    return runOn(run);
}

} // namespace gorizont::tool
