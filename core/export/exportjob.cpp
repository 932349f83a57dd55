#include "core/export/exportjob.h"

#include "core/export/exportsentences.h"

#include <algorithm>

namespace gorizont {

namespace {

/// QSaveFile itself does not notice that the last of its bytes did not fit. The second flush() brings the reason.
bool commit(QSaveFile &file)
{
    return (file.flush() || file.flush()) && file.commit();
}

} // namespace

ExportJob::ExportJob(const ExportRequest &request, const ArchiveSource &source, ExportWatch &watch)
    : m_request(request)
    , m_source(source)
    , m_watch(watch)
    , m_file(request.path)
{
}

/// A file that was not committed is gone with the job.
ExportResult ExportJob::run()
{
    if (!m_file.open(QIODevice::WriteOnly)) {
        fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
    } else if (writeAll() && !m_watch.isCancelled) {
        finish();
    }
    m_result.isCancelled = m_watch.isCancelled && m_result.files.isEmpty();
    if (m_result.isCancelled) {
        m_result.failure.clear();
    }
    return m_result;
}

void ExportJob::finish()
{
    if (m_result.rows == 0) {
        return fail(exportsentence::nothingFound());
    }
    if (!commit(m_file)) {
        return fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
    }
    m_result.files << m_request.path;
    writeNotes();
}

bool ExportJob::write(const QByteArray &bytes)
{
    if (m_file.write(bytes) == bytes.size()) {
        return true;
    }
    fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
    return false;
}

bool ExportJob::writeBeside(const QString &path, const QByteArray &bytes)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !commit(file)) {
        fail(exportsentence::cannotWrite(path, file.errorString()));
        return false;
    }
    m_result.files << path;
    return true;
}

void ExportJob::fail(const QString &sentence)
{
    if (m_result.failure.isEmpty()) {
        m_result.failure = sentence;
    }
}

void ExportJob::failSourceGone()
{
    fail(exportsentence::sourceGone());
}

bool ExportJob::report(double share)
{
    if (m_watch.progress) {
        m_watch.progress(static_cast<int>(std::clamp(share, 0.0, 1.0) * 100), m_result.rows);
    }
    return !m_watch.isCancelled;
}

} // namespace gorizont
