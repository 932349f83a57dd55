#pragma once

#include "core/export/exportrun.h"

#include <QObject>

#include <memory>

class QThread;

namespace gorizont {

/// An export in a thread of its own. Lives in the thread of whoever wants it; one export at a time.
class Export : public QObject
{
    Q_OBJECT

public:
    explicit Export(const ArchiveSource &source, QObject *parent = nullptr);
    /// Cancels what runs, and waits for its end: a fraction of a second.
    ~Export() override;

    /// Does nothing while an export runs.
    void start(const ExportRequest &request);
    void cancel();
    bool isRunning() const { return m_thread != nullptr; }

Q_SIGNALS:
    void progressed(int percent, quint64 rows);
    void finished(const gorizont::ExportResult &result);

private:
    void end(const ExportResult &result);

    const ArchiveSource m_source;
    std::unique_ptr<QThread> m_thread; ///< empty: nothing runs
    std::unique_ptr<ExportWatch> m_watch;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::ExportResult)
