#include "core/export/export.h"

#include <QThread>

namespace gorizont {

Export::Export(const ArchiveSource &source, QObject *parent)
    : QObject(parent)
    , m_source(source)
{
}

Export::~Export()
{
    if (m_thread) {
        cancel();
        m_thread->wait();
    }
}

void Export::start(const ExportRequest &request)
{
    if (m_thread) {
        return;
    }
    m_watch = std::make_unique<ExportWatch>();
    m_watch->progress = [this](int percent, quint64 rows) { Q_EMIT progressed(percent, rows); };
    m_thread.reset(QThread::create([this, request, watch = m_watch.get()] {
        const ExportResult result = runExport(request, m_source, *watch);
        QMetaObject::invokeMethod(
            this, [this, result] { end(result); }, Qt::QueuedConnection);
    }));
    m_thread->setObjectName(QStringLiteral("export"));
    m_thread->start(QThread::LowPriority);
}

void Export::cancel()
{
    if (m_watch) {
        m_watch->isCancelled = true;
    }
}

void Export::end(const ExportResult &result)
{
    m_thread->wait();
    m_thread.reset();
    Q_EMIT finished(result);
}

} // namespace gorizont
