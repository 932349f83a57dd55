#include "core/station/service/stationstorage.h"

#include "core/files/wholefile.h"

#include <QCoreApplication>
#include <QDir>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto retryPause = 5s;
constexpr std::size_t mostOpen = 32; ///< files; a new month or day opens more

/// The last line of \a path that names its columns; empty: there is none.
QByteArray lastHeading(const QString &path)
{
    QFile file(path);
    QByteArray heading;
    if (file.open(QIODevice::ReadOnly)) {
        while (!file.atEnd()) {
            const QByteArray line = file.readLine();
            heading = line.startsWith(';') ? line : heading;
        }
    }
    return heading;
}

} // namespace

StationStorage::StationStorage(const QString &folder, QObject *parent)
    : QObject(parent)
    , m_folder(folder)
{
    m_retry.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &StationStorage::flush);
}

void StationStorage::add(const StoredLine &line)
{
    if (m_posted >= mostWaiting) {
        return;
    }
    ++m_posted;
    QMetaObject::invokeMethod(
        this,
        [this, line] {
            --m_posted;
            m_waiting.push_back(line);
            if (m_waiting.size() > mostWaiting) {
                m_waiting.pop_front();
            }
            if (!m_retry.isActive()) {
                flush();
            }
        },
        Qt::QueuedConnection);
}

void StationStorage::keep(const QString &path, const QByteArray &bytes)
{
    QMetaObject::invokeMethod(
        this,
        [this, path, bytes] {
            QDir().mkpath(m_folder);
            if (const QString problem = writeWholeFile(QDir(m_folder).filePath(path), bytes); !problem.isEmpty()) {
                Q_EMIT told(false, tr("The clock that was set is lost at the next start: %1").arg(problem));
            }
        },
        Qt::QueuedConnection);
}

void StationStorage::flush()
{
    while (!m_waiting.empty()) {
        if (!write(m_waiting.front())) {
            m_retry.start(retryPause);
            return;
        }
        m_waiting.pop_front();
    }
    if (m_isBad) {
        m_isBad = false;
        Q_EMIT told(true, tr("Records are saved again."));
    }
}

void StationStorage::end()
{
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    flush();
    m_retry.stop();
}

/// The names of the columns go before the first record, and before the first one that has others.
bool StationStorage::write(const StoredLine &line)
{
    const QString path = QDir(m_folder).filePath(line.path);
    if (m_files.size() > mostOpen) {
        m_files.clear();
        m_headings.clear();
    }
    RecordFile &file = m_files[path];
    const RecordFile::State state = file.prepare(path);
    if (state == RecordFile::State::Failed) {
        fail(file.error());
        return false;
    }
    if (file.takeRepaired()) {
        Q_EMIT told(true, tr("The unfinished last record of %1 was removed.").arg(line.path));
    }
    if (state == RecordFile::State::Opened) {
        m_headings[path] = lastHeading(path);
    }
    const bool isHeaded = m_headings.value(path) == line.heading;
    if (!file.append(isHeaded ? line.record : line.heading + line.record)) {
        fail(file.error());
        return false;
    }
    m_headings[path] = line.heading;
    return true;
}

void StationStorage::fail(const QString &why)
{
    if (!m_isBad) {
        m_isBad = true;
        Q_EMIT told(false, tr("Records cannot be saved (%1). The newest %2 wait.").arg(why).arg(mostWaiting));
    }
}

} // namespace gorizont::station
