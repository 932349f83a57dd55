#pragma once

#include "core/export/exportrun.h"

#include <QSaveFile>
#include <QSemaphore>

#include <memory>

namespace gorizont {

/// One export while it runs: what both kinds of files share. In the thread of runExport().
class ExportJob
{
public:
    ExportJob(const ExportRequest &request, const ArchiveSource &source, ExportWatch &watch);
    virtual ~ExportJob() = default;
    Q_DISABLE_COPY_MOVE(ExportJob)

    ExportResult run();

protected:
    /// False: cancelled, or failed.
    virtual bool writeAll() = 0;
    /// What lies beside the file, once it is whole. False: failed.
    virtual bool writeNotes() { return true; }

    /// Empty: cancelled, or the source has gone.
    template <typename T> std::optional<T> wait(QFuture<T> future);

    bool write(const QByteArray &bytes);
    /// A file of its own beside that of the export.
    bool writeBeside(const QString &path, const QByteArray &bytes);
    void fail(const QString &sentence);
    void failSourceGone();
    bool report(double share); ///< 0…1. False: cancelled

    const ExportRequest &m_request;
    const ArchiveSource &m_source;
    ExportResult m_result;

private:
    void finish();

    ExportWatch &m_watch;
    QSaveFile m_file;
};

template <typename T> std::optional<T> ExportJob::wait(QFuture<T> future)
{
    constexpr int slice = 50; // ms: the longest time until a cancelled export notices
    const auto done = std::make_shared<QSemaphore>();
    future.then(QtFuture::Launch::Sync, [done](QFuture<T>) { done->release(); }).onCanceled([done] {
        done->release();
    });
    while (!done->tryAcquire(1, slice)) {
        if (m_watch.isCancelled) {
            future.cancel();
            return {};
        }
    }
    if (future.isCanceled() || future.resultCount() == 0) {
        failSourceGone();
        return {};
    }
    return future.result();
}

} // namespace gorizont
