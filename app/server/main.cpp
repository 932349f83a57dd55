#include "app/server/application.h"
#include "app/server/demosite.h"
#include "app/server/opcservice.h"
#include "app/server/singleinstance.h"
#include "app/server/startup.h"
#include "app/server/windowpages.h"
#include "app/unixsignals.h"
#include "core/modbus/registerdocument.h"
#include "core/opc/opctags.h"
#include "translations/translation.h"
#include "ui/firstrundialog.h"
#include "ui/mainwindow.h"
#include "ui/opctagsdialog.h"
#include "ui/registermapdialog.h"
#include "ui/trayicon.h"

#include <QApplication>
#include <QMessageBox>

#include <cstdio>
#include <cstdlib>

using namespace gorizont;

namespace {

class Main
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Main)
};

/// Whether \a arguments ask for something that needs no window; known before anything is parsed.
bool needsNoWindow(int argc, char **argv)
{
    static const QByteArrayList words{"--headless", "--help", "--version", "--print-register-map", "--print-opc-tags"};
    for (int i = 1; i < argc; ++i) {
        if (words.contains(QByteArray(argv[i]))) {
            return true;
        }
    }
    return false;
}

/// Without a display Qt would end the program with an abort.
bool hasDisplay()
{
#ifdef Q_OS_LINUX
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY")
        || qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

int fail(const QString &sentence, const Options &options, int code = ExitFailed)
{
    std::fprintf(stderr, "gorizont-server: %s\n", qPrintable(sentence));
    if (!options.isHeadless) {
        QMessageBox::critical(nullptr, QStringLiteral("Gorizont Server"), sentence);
    }
    return code;
}

int sayLastWords(const LastWords &words)
{
    std::FILE *stream = words.exitCode == ExitGood ? stdout : stderr;
    std::fprintf(stream, "%s\n", qPrintable(words.text.trimmed()));
    return words.exitCode;
}

/// Asks what to do without an ini. False: the user wants the program to end.
bool chooseSite(Options &options, QString *configFile)
{
    FirstRunDialog dialog({QCoreApplication::applicationDirPath()});
    dialog.exec();
    if (dialog.choice() == FirstRunDialog::Choice::ChooseFile) {
        options.configFile = FirstRunDialog::askForFile();
    }
    options.isDemo = dialog.choice() == FirstRunDialog::Choice::StartDemo;
    *configFile = findConfigFile(options);
    return options.isDemo || !options.configFile.isEmpty();
}

/// The journal on stderr, where a service manager looks for it.
void echoJournal(const Journal &journal)
{
    QObject::connect(&journal, &Journal::added, &journal, [](const JournalEntry &entry) {
        std::fprintf(stderr, "%s\n", qPrintable(entry.text));
    });
}

int runHeadless(Application &application, UnixSignals &signals_)
{
    echoJournal(application.journal());
    QObject::connect(&signals_, &UnixSignals::terminated, QCoreApplication::instance(), &QCoreApplication::quit);
    application.start();
    return QCoreApplication::exec();
}

int runWindow(Application &application, const Site &site, SingleInstance &instance, UnixSignals &signals_)
{
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/gorizont.svg")));
    MainWindow window(
        application.registry(), application.journal(), application.alarms(), site.reading.config,
        site.reading.complaints);
    window.offerService(
        [&application](int port) { return application.worker(port); }, application.journal(), application.recordSink());
    addWindowPages(
        window,
        {application.registry(), application.archive(), site.reading.config, site.dataFolder,
         [&application](int port) { return application.worker(port); }});
    const TrayIcon tray(window, application.registry(), application.alarms());
    QObject::connect(&window, &MainWindow::retryRequested, &application, &Application::retryLines);
    QObject::connect(&application, &Application::measurementWritten, &window, &MainWindow::appendMeasurement);
    QObject::connect(&application, &Application::serverStatusChanged, &window, &MainWindow::setServerStatus);
    QObject::connect(&application, &Application::clientsChanged, &window, &MainWindow::setClients);
    QObject::connect(&window, &MainWindow::clientDismissed, &application, &Application::dismissClient);
    QObject::connect(&instance, &SingleInstance::raiseRequested, &window, &MainWindow::raiseWindow);
    QObject::connect(&window, &MainWindow::registerMapRequested, &window, [&window, &site] {
        (new RegisterMapDialog(registerDocument(site.reading.config), &window))->show();
    });
    const auto showTags = [&window, &site](const QString &message) {
        (new OpcTagsDialog(
             QString::fromUtf8(opcTagList(opcTags(site.reading.config.lines, opcWeatherOf(site.reading.config.lines)))),
             message, &window))
            ->show();
    };
    QObject::connect(&window, &MainWindow::opcTagsRequested, &window, [showTags] { showTags({}); });
    QObject::connect(&application, &Application::opcFirstRunDone, &window, showTags);
    QObject::connect(&window, &MainWindow::exitRequested, QCoreApplication::instance(), &QCoreApplication::quit);
    // Not quit() alone: that asks the windows, and CanClose=0 would ask the user.
    QObject::connect(&signals_, &UnixSignals::terminated, &window, &MainWindow::endWithoutQuestion);
    application.start();
    window.showAtStart();
    return QApplication::exec();
}

/// The second copy gives way: it shows the window of the first one.
int giveWay(const SingleInstance &instance, const Site &site, const Options &options)
{
    if (!options.isHeadless && instance.raiseOther()) {
        return ExitSecondCopy;
    }
    return fail(
        Main::tr("Gorizont Server already works with the folder %1. Close that copy, or give this one a folder of its "
                 "own "
                 "with --data.")
            .arg(site.dataFolder),
        options, ExitSecondCopy);
}

int runSite(const Options &options, Site site)
{
    const ServerConfig &config = site.reading.config;
    SingleInstance instance(site.dataFolder);
    const bool isFirst = instance.acquire();
    if (!isFirst && !config.allowsCopy) {
        return giveWay(instance, site, options);
    }
    if (config.servesOpc && !instance.acquireOpc(config.opc.port)) {
        return fail(
            Main::tr(
                "With CanOPCDA=1 only one copy of the program may work, and another one serves OPC DA already. Close "
                "that copy, or set CanOPCDA=0 for this one."),
            options, ExitSecondCopy);
    }
    std::unique_ptr<DemoSite> demo;
    if (options.isDemo) {
        demo = std::make_unique<DemoSite>(site.reading.config.lines);
    }
    UnixSignals signals_;
    Application application(
        {config, site.reading.complaints, site.dataFolder, isFirst, {options.portsFolder}, options.printsReadings});
    const int code =
        options.isHeadless ? runHeadless(application, signals_) : runWindow(application, site, instance, signals_);
    if (!application.shutdown()) {
        // PExit is over and a thread still hangs in the system; the files are whole at any moment.
        std::_Exit(ExitFailed);
    }
    return code;
}

/// The language of the ini, unless the command line chose one. Whether that changed the language.
bool followLanguage(const Options &options, const ServerConfig &config)
{
    const bool decides = options.language.isEmpty() && !config.language.isEmpty();
    if (decides) {
        installTranslation(config.language);
    }
    return decides;
}

/// Prints what \a document makes of the configuration, and nothing else.
int print(
    const Options &options, const QString &configFile, const std::function<QByteArray(const ServerConfig &)> &document)
{
    QString problem;
    const auto reading = loadConfig(configFile, &problem);
    if (!reading) {
        return fail(problem, options);
    }
    followLanguage(options, reading->config);
    const QByteArray text = document(reading->config);
    const bool isWritten = std::fwrite(text.constData(), 1, static_cast<std::size_t>(text.size()), stdout)
            == static_cast<std::size_t>(text.size())
        && std::fflush(stdout) == 0;
    return isWritten ? ExitGood : ExitFailed;
}

int run(Options options)
{
    QString configFile = findConfigFile(options);
    if (configFile.isEmpty()) {
        if (options.isHeadless) {
            return fail(
                Main::tr("There is no GorizontServer.ini. Name one with --config, or look at the program "
                         "with --demo."),
                options);
        }
        if (!chooseSite(options, &configFile)) {
            return ExitGood;
        }
    }
    if (options.printsRegisterMap) {
        return print(options, configFile, [](const ServerConfig &config) { return registerDocument(config).toUtf8(); });
    }
    if (options.printsOpcTags) {
        return print(options, configFile, [](const ServerConfig &config) {
            return opcTagList(opcTags(config.lines, opcWeatherOf(config.lines)));
        });
    }
    QString problem;
    auto site = loadSite(options, configFile, &problem);
    if (site && followLanguage(options, site->reading.config)) {
        site = loadSite(options, configFile, &problem); // again, so that its complaints are in that language
    }
    return site ? runSite(options, *std::move(site)) : fail(problem, options);
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("gorizont-server"));
    QCoreApplication::setApplicationVersion(QStringLiteral(GORIZONT_VERSION));
    const bool isWindowless = needsNoWindow(argc, argv);
    const bool isBlind = !isWindowless && !hasDisplay();
    const std::unique_ptr<QCoreApplication> application(
        isWindowless || isBlind ? new QCoreApplication(argc, argv) : new QApplication(argc, argv));
    const QStringList arguments = QCoreApplication::arguments();
    installTranslation(languageArgument(arguments));
    if (isBlind) {
        return sayLastWords({ExitFailed, Main::tr("There is no display. Start the program with --headless.")});
    }
    const auto parsed = parseOptions(arguments);
    if (const auto *words = std::get_if<LastWords>(&parsed)) {
        return sayLastWords(*words);
    }
    return run(std::get<Options>(parsed));
}
