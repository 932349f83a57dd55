#include "app/configfile.h"
#include "app/ptyport.h"
#include "app/unixsignals.h"
#include "core/simulation/simulatedtcpport.h"
#include "translations/translation.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>

#include <cstdio>
#include <cstring>

using namespace gorizont;

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Simulator)
};

constexpr int usageError = 2;

int complain(const QString &text)
{
    std::fprintf(stderr, "gorizont-simulator: %s\n", qPrintable(text));
    return usageError;
}

void addOptions(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr("Plays the sensors of an ini file: every port becomes a pty linked as DIR/COMn, a port with "
                 "Device=tcp://127.0.0.1:port listens there.\n\n"
                 "Faults, each KIND=VALUE[@FROM[-TO]] with times in seconds since the start:\n"
                 "  silent=N     the sensor with site number N does not answer\n"
                 "  crc=P        P % of the answers have a wrong byte\n"
                 "  garbage=P    P % of the answers come after garbage\n"
                 "  pieces=P     P % of the answers come in pieces\n"
                 "  late=P       P % of the answers come 1.5 s late\n"
                 "  reboot=N     the sensor N restarts, once at FROM\n"
                 "  overrun=N    the ring of the sensor N is overwritten, once at FROM\n"
                 "  gone=n:S     the port COMn is gone for S seconds, once at FROM"));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions({
        {QStringLiteral("config"), Text::tr("The ini that lists the sensors."), QStringLiteral("FILE")},
        {QStringLiteral("ports"), Text::tr("Folder for the links COMn."), QStringLiteral("DIR")},
        {QStringLiteral("seed"), Text::tr("Another building."), QStringLiteral("N"), QStringLiteral("1")},
        {QStringLiteral("fault"), Text::tr("Something that goes wrong."), QStringLiteral("KIND=VALUE")},
    });
}

/// Empty when one of them cannot be read; \a wrong is that one.
std::optional<FaultPlan> parseFaults(const QStringList &texts, QString *wrong)
{
    FaultPlan plan;
    for (const QString &text : texts) {
        const auto fault = parseSimulatedFault(text);
        if (!fault) {
            *wrong = text;
            return std::nullopt;
        }
        plan.append(*fault);
    }
    return plan;
}

template <typename Port> void planDisappearances(const FaultPlan &plan, const LineConfig &line, Port *port)
{
    for (const SimulatedFault &fault : plan) {
        if (fault.kind != SimulatedFault::Kind::Gone || static_cast<int>(fault.value) != line.com) {
            continue;
        }
        const auto from = std::chrono::duration_cast<std::chrono::milliseconds>(fault.from);
        const auto length = std::chrono::duration_cast<std::chrono::milliseconds>(fault.length);
        QTimer::singleShot(from, port, [port] { port->unplug(); });
        QTimer::singleShot(from + length, port, [port] { port->plug(); });
    }
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("gorizont-simulator"));
    QCoreApplication::setApplicationVersion(QStringLiteral(GORIZONT_VERSION));
    installTranslation({});
    QCommandLineParser parser;
    addOptions(parser);
    parser.process(application);
    if (!parser.isSet(QStringLiteral("config")) || !parser.isSet(QStringLiteral("ports"))) {
        return complain(Text::tr("--config FILE and --ports DIR are needed"));
    }
    QString wrong;
    const auto faults = parseFaults(parser.values(QStringLiteral("fault")), &wrong);
    if (!faults) {
        return complain(Text::tr("--fault %1 is not understood; --help lists what can go wrong").arg(wrong));
    }
    const auto reading = readConfigFile(parser.value(QStringLiteral("config")), &wrong);
    if (!reading) {
        return complain(QStringLiteral("%1: %2").arg(parser.value(QStringLiteral("config")), wrong));
    }
    const QString directory = parser.value(QStringLiteral("ports"));
    if (!QDir().mkpath(directory)) {
        return complain(Text::tr("the folder %1 cannot be made").arg(directory));
    }

    UnixSignals signals_;
    QObject::connect(&signals_, &UnixSignals::terminated, &application, &QCoreApplication::quit);
    const SimulatedBus::Options options{parser.value(QStringLiteral("seed")).toULongLong(), *faults};
    std::vector<std::unique_ptr<PtyPort>> ports;
    std::vector<std::unique_ptr<SimulatedTcpPort>> sockets;
    for (const LineConfig &line : reading->config.lines) {
        if (SimulatedTcpPort::isOwn(line.device)) {
            sockets.push_back(std::make_unique<SimulatedTcpPort>(line, options));
            if (!sockets.back()->plug()) {
                return complain(QStringLiteral("%1: %2").arg(line.device, sockets.back()->errorString()));
            }
            planDisappearances(*faults, line, sockets.back().get());
            std::printf("%s: %zu sensors\n", qPrintable(line.device), sockets.back()->bus().devices().size());
        }
        if (!line.device.isEmpty()) {
            continue;
        }
        ports.push_back(std::make_unique<PtyPort>(line, options, directory));
        if (!ports.back()->plug()) {
            return complain(
                QStringLiteral("%1: %2").arg(ports.back()->linkPath(), QString::fromLocal8Bit(std::strerror(errno))));
        }
        planDisappearances(*faults, line, ports.back().get());
        std::printf("%s: %zu sensors\n", qPrintable(ports.back()->linkPath()), ports.back()->sensorCount());
    }
    std::printf("ready\n");
    std::fflush(stdout);
    return QCoreApplication::exec();
}
