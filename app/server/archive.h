#pragma once

#include "core/archive/archivereader.h"
#include "core/archive/archivewriter.h"
#include "core/config/serverconfig.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"

#include <QDeadlineTimer>

namespace gorizont {

/// The archive of the site: the writer in a thread of its own, for a slow store must not keep the text files waiting,
/// and the reader for the pages. Main thread.
class Archive : public QObject
{
    Q_OBJECT

public:
    struct Site
    {
        const ServerConfig &config;
        QString dataFolder;
        bool isWritten = true; ///< false: another copy of the program writes it
        SensorRegistry &registry;
        Journal &journal;
    };

    explicit Archive(const Site &site);
    /// Waits for the writer.
    ~Archive() override;

    ArchiveReader &reader() { return m_reader; }
    /// Readings that wait for the store.
    std::size_t backlog() const { return m_writer ? m_writer->backlog() : 0; }

    /// What a service window downloaded; empty: nobody writes the archive here.
    std::function<void(const DeviceRecords &)> recordSink();

    void start();
    void stop();
    /// After stop(). False: the writer or the reader did not end in time.
    bool wait(const QDeadlineTimer &deadline) { return m_thread.wait(deadline) && m_reader.wait(deadline); }

private:
    void makeWriter(const ArchiveConfig &config, const Site &site);

    QThread m_thread;
    std::unique_ptr<ArchiveWriter> m_writer; ///< empty: this copy does not write
    ArchiveReader m_reader;
};

} // namespace gorizont
