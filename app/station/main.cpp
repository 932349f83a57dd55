#include "app/station/options.h"
#include "app/station/stationapplication.h"
#include "app/unixsignals.h"
#include "translations/translation.h"

#include <QCoreApplication>
#include <QDir>

#include <cstdio>
#include <cstdlib>

using namespace gorizont;

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::StationMain)
};

int fail(const QString &text, int code)
{
    std::fprintf(stderr, "gorizont-station: %s\n", qPrintable(text));
    return code;
}

int run(const StationOptions &options)
{
    if (!QDir(options.configFolder).exists()) {
        return fail(
            Text::tr("There is no folder %1. Name the one with ACK.INI with --config.")
                .arg(QDir::toNativeSeparators(options.configFolder)),
            StationFailed);
    }
    if (!QDir().mkpath(options.dataFolder)) {
        return fail(
            Text::tr("The folder %1 for the data cannot be made. Choose another one with --data.")
                .arg(QDir::toNativeSeparators(options.dataFolder)),
            StationFailed);
    }
    UnixSignals signals_;
    signals_.catchHangup();
    StationApplication application(options);
    if (!application.acquire()) {
        return fail(
            Text::tr(
                "A station already works with the folder %1. End that program, or give this one a folder of its own "
                "with --data.")
                .arg(QDir::toNativeSeparators(options.dataFolder)),
            StationSecondCopy);
    }
    QObject::connect(&signals_, &UnixSignals::terminated, QCoreApplication::instance(), &QCoreApplication::quit);
    QObject::connect(&signals_, &UnixSignals::hungUp, &application, &StationApplication::reload);
    application.start();
    const int code = QCoreApplication::exec();
    if (!application.shutdown()) {
        // A thread still hangs in the system; the files are whole at any moment.
        std::_Exit(StationFailed);
    }
    return code;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("gorizont-station"));
    QCoreApplication::setApplicationVersion(QStringLiteral(GORIZONT_VERSION));
    const QStringList arguments = QCoreApplication::arguments();
    installTranslation(stationLanguage(arguments));
    const auto parsed = parseStationOptions(arguments);
    if (const auto *words = std::get_if<StationLastWords>(&parsed)) {
        std::fprintf(words->exitCode == StationGood ? stdout : stderr, "%s\n", qPrintable(words->text));
        return words->exitCode;
    }
    return run(std::get<StationOptions>(parsed));
}
