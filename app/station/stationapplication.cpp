#include "app/station/stationapplication.h"

#include "core/history/historyformat.h"
#include "core/values/weatherjson.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>

#include <cstdio>

namespace gorizont {

namespace {

constexpr auto exitLimit = std::chrono::seconds(10);

station::StationSetup setupOf(const StationOptions &options)
{
    station::StationSetup setup;
    setup.configFolder = options.configFolder;
    setup.dataFolder = options.dataFolder;
    setup.ports = {options.portsFolder};
    setup.listen = options.listen;
    setup.maySetClock = options.maySetClock;
    return setup;
}

} // namespace

StationApplication::StationApplication(const StationOptions &options, QObject *parent)
    : QObject(parent)
    , m_options(options)
    , m_thread(setupOf(options))
{
    station::Station *station = &m_thread.station();
    connect(station, &station::Station::journal, this, &StationApplication::write);
    connect(station, &station::Station::protocolAllowed, this, [this](bool isAllowed) { m_isLogWanted = isAllowed; });
    if (options.prints) {
        connect(station, &station::Station::measured, this, &StationApplication::print);
    }
}

void StationApplication::reload()
{
    QMetaObject::invokeMethod(&m_thread.station(), &station::Station::reload, Qt::QueuedConnection);
}

bool StationApplication::shutdown()
{
    const bool hasEnded = m_thread.stop(exitLimit);
    // What the station said at its end: no event loop delivers it any more.
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    return hasEnded;
}

/// stderr is where a service manager looks.
void StationApplication::write(const JournalEntry &entry)
{
    std::fprintf(stderr, "%s\n", qPrintable(entry.text));
    if (!m_isLogWanted) {
        return;
    }
    const QDate day = localTime(entry.time, {}).date();
    const QString path = QDir(m_options.dataFolder).filePath(monthFileName(day, MonthFile::Log));
    const bool isWritten = m_log.append(path, logRecord(entry, {}));
    if (isWritten == m_isLogBad) {
        m_isLogBad = !isWritten;
        std::fprintf(
            stderr, "%s\n",
            qPrintable(
                isWritten ? tr("The log is written again.") : tr("The log cannot be written: %1").arg(m_log.error())));
    }
}

void StationApplication::print(const Weather &weather, qint64 clock)
{
    if (m_isStdoutClosed) {
        return;
    }
    QJsonObject object;
    object.insert(
        QStringLiteral("time"), station::StationClock::dateTime(clock).toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss")));
    insertWeather(object, weather);
    const QByteArray line = QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
    const auto size = static_cast<std::size_t>(line.size());
    m_isStdoutClosed = std::fwrite(line.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0;
}

} // namespace gorizont
