#pragma once

#include "core/archive/archivequery.h"

#include <QDeadlineTimer>
#include <QFuture>
#include <QObject>
#include <QPromise>
#include <QThread>

#include <memory>

namespace gorizont {

/// Answers questions about the archive in a thread of its own, one after the other; a question that is cancelled costs
/// nothing more. What an archive that cannot be read would have answered is cancelled. Made and asked on any one thread; its
/// end waits for the answer that is being made and cancels the rest.
class ArchiveReader : public QObject
{
    Q_OBJECT

public:
    explicit ArchiveReader(const ArchiveConfig &config, QObject *parent = nullptr);
    ~ArchiveReader() override;

    QFuture<QList<Series>> series(const SeriesQuery &query);
    QFuture<QList<Gap>> gaps(const QList<int> &numbers, UtcTime from, UtcTime to);
    QFuture<QList<DayCompleteness>> completeness(const QList<int> &numbers, QDate first, QDate last);
    QFuture<QList<JournalEntry>> events(UtcTime from, UtcTime to, int most);
    QFuture<QList<SampleBlock>> blocks(int number, UtcTime from, UtcTime to);
    QFuture<QList<DeviceRecord>> records(int number, UtcTime from, UtcTime to);

    /// series() as a source; it must not outlive the reader.
    SeriesSource source();

    /// From now on only the question that is being answered is. The destructor waits for that one without limit.
    void stop();
    /// After stop(). False: the store did not answer in time.
    bool wait(const QDeadlineTimer &deadline) { return m_thread.wait(deadline); }

public Q_SLOTS:
    /// The file is another one.
    void reopen();

private:
    template <typename T>
    QFuture<T> ask(const std::function<T(ArchiveQuery &, const ArchiveQuery::IsCancelled &)> &question);

    std::unique_ptr<ArchiveQuery> m_query; ///< of the thread
    QObject *m_worker = nullptr; ///< lives in the thread, deleted by its end
    QThread m_thread;
};

} // namespace gorizont
