#include "core/archive/archivereader.h"

namespace gorizont {

ArchiveReader::ArchiveReader(const ArchiveConfig &config, QObject *parent)
    : QObject(parent)
    , m_query(std::make_unique<ArchiveQuery>(config))
    , m_worker(new QObject)
{
    m_thread.setObjectName(QStringLiteral("archive reader"));
    m_worker->moveToThread(&m_thread);
    connect(
        &m_thread, &QThread::finished, m_worker, [this] { m_query.reset(); }, Qt::DirectConnection);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start();
}

ArchiveReader::~ArchiveReader()
{
    stop();
    m_thread.wait();
}

void ArchiveReader::stop()
{
    m_thread.requestInterruption();
    m_thread.quit();
}

void ArchiveReader::reopen()
{
    QMetaObject::invokeMethod(m_worker, [this] { m_query->reopen(); });
}

template <typename T>
QFuture<T> ArchiveReader::ask(const std::function<T(ArchiveQuery &, const ArchiveQuery::IsCancelled &)> &question)
{
    const auto promise = std::make_shared<QPromise<T>>();
    promise->start();
    QMetaObject::invokeMethod(m_worker, [this, promise, question] {
        const ArchiveQuery::IsCancelled isCancelled = [this, &promise] {
            return promise->isCanceled() || m_thread.isInterruptionRequested();
        };
        if (!isCancelled()) {
            T answer = question(*m_query, isCancelled);
            if (!m_query->takeFailure() && !isCancelled()) {
                promise->addResult(std::move(answer));
            }
        }
        if (promise->future().resultCount() == 0) {
            promise->future().cancel();
        }
        promise->finish();
    });
    return promise->future();
}

QFuture<QList<Series>> ArchiveReader::series(const SeriesQuery &query)
{
    return ask<QList<Series>>([query](ArchiveQuery &archive, const ArchiveQuery::IsCancelled &isCancelled) {
        return archive.series(query, isCancelled);
    });
}

QFuture<QList<Gap>> ArchiveReader::gaps(const QList<int> &numbers, UtcTime from, UtcTime to)
{
    return ask<QList<Gap>>(
        [numbers, from, to](ArchiveQuery &archive, const auto &) { return archive.gaps(numbers, from, to); });
}

QFuture<QList<DayCompleteness>> ArchiveReader::completeness(const QList<int> &numbers, QDate first, QDate last)
{
    return ask<QList<DayCompleteness>>([numbers, first, last](ArchiveQuery &archive, const auto &) {
        return archive.completeness(numbers, first, last, QTimeZone::systemTimeZone());
    });
}

QFuture<QList<JournalEntry>> ArchiveReader::events(UtcTime from, UtcTime to, int most)
{
    return ask<QList<JournalEntry>>(
        [from, to, most](ArchiveQuery &archive, const auto &) { return archive.events(from, to, most); });
}

QFuture<QList<SampleBlock>> ArchiveReader::blocks(int number, UtcTime from, UtcTime to)
{
    return ask<QList<SampleBlock>>(
        [number, from, to](ArchiveQuery &archive, const auto &) { return archive.blocks(number, from, to); });
}

QFuture<QList<DeviceRecord>> ArchiveReader::records(int number, UtcTime from, UtcTime to)
{
    return ask<QList<DeviceRecord>>(
        [number, from, to](ArchiveQuery &archive, const auto &) { return archive.records(number, from, to); });
}

SeriesSource ArchiveReader::source()
{
    return [this](const SeriesQuery &query) { return series(query); };
}

} // namespace gorizont
