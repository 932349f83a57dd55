#include "app/server/archive.h"

namespace gorizont {

Archive::Archive(const Site &site)
    : m_reader(archiveConfig(site.config, site.dataFolder))
{
    m_thread.setObjectName(QStringLiteral("archive"));
    if (site.config.archive.isOn && site.isWritten) {
        makeWriter(archiveConfig(site.config, site.dataFolder), site);
    }
}

Archive::~Archive()
{
    m_thread.quit();
    m_thread.wait();
}

void Archive::makeWriter(const ArchiveConfig &config, const Site &site)
{
    m_writer = std::make_unique<ArchiveWriter>(config);
    ArchiveWriter *writer = m_writer.get();
    // Direct: the slots only leave the values in an inbox of bounded size.
    connect(
        &site.registry, &SensorRegistry::readingsChanged, writer, &ArchiveWriter::updateReadings, Qt::DirectConnection);
    connect(&site.registry, &SensorRegistry::lineChanged, writer, &ArchiveWriter::updateLine, Qt::DirectConnection);
    connect(&site.registry, &SensorRegistry::blockAdded, writer, &ArchiveWriter::appendBlock, Qt::DirectConnection);
    connect(&site.journal, &Journal::added, writer, &ArchiveWriter::appendJournal, Qt::DirectConnection);
    connect(writer, &ArchiveWriter::journal, &site.journal, &Journal::append);
    connect(writer, &ArchiveWriter::replaced, &m_reader, &ArchiveReader::reopen);
    for (const LineStatus &status : site.registry.lineStatuses()) {
        writer->updateLine(status);
    }
    writer->moveToThread(&m_thread);
    connect(&m_thread, &QThread::started, writer, &ArchiveWriter::start);
    connect(&m_thread, &QThread::finished, writer, &ArchiveWriter::stop, Qt::DirectConnection);
}

/// The slot only leaves the records in an inbox of bounded size.
std::function<void(const DeviceRecords &)> Archive::recordSink()
{
    if (!m_writer) {
        return {};
    }
    return [writer = m_writer.get()](const DeviceRecords &records) { writer->appendRecords(records); };
}

void Archive::stop()
{
    m_reader.stop();
    m_thread.quit();
}

void Archive::start()
{
    if (m_writer) {
        m_thread.start();
    }
}

} // namespace gorizont
