#include "core/archive/inspection.h"

#include "core/archive/archivedatabase.h"
#include "core/archive/readingchunk.h"
#include "core/archive/retention.h"
#include "core/archive/rollupchunk.h"
#include "core/archive/samplechunk.h"
#include "core/archive/tailbatch.h"

#include <QDir>
#include <QFile>

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

class Inspection
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Inspection)

public:
    explicit Inspection(const ArchiveConfig &config)
        : m_database(config, ArchiveDatabase::Access::Read)
    {
    }

    bool open(QString *error)
    {
        const bool isThere = !m_database.isSqlite() || QFile::exists(m_database.config().file);
        if (!isThere || !m_database.open()) {
            *error = isThere ? m_database.error()
                             : tr("There is no archive %1.").arg(QDir::toNativeSeparators(m_database.config().file));
            return false;
        }
        return true;
    }

    void count()
    {
        m_report.bytes = usedBytes(m_database);
        for (const auto &[table, number] : counters()) {
            *number = m_database.single(u"SELECT count(*) FROM "_s + table).toLongLong();
        }
    }

    void readAll()
    {
        readChunks();
        readRollups();
        readTail();
        if (!m_database.isSqlite()) {
            return;
        }
        QSqlQuery *rows = m_database.run(u"PRAGMA integrity_check(20)"_s);
        while (rows && rows->next()) {
            const QString line = rows->value(0).toString();
            if (line != u"ok") {
                m_report.problems.append(line);
            }
        }
        if (!rows) {
            m_report.problems.append(m_database.error());
        }
    }

    ArchiveDatabase &database() { return m_database; }
    const ArchiveReport &report() const { return m_report; }

private:
    QList<std::pair<QString, qint64 *>> counters()
    {
        return {{u"chunk"_s, &m_report.chunks}, {u"rollup"_s, &m_report.rollups}, {u"tail"_s, &m_report.commits},
                {u"event"_s, &m_report.events}, {u"gap"_s, &m_report.gaps},       {u"record"_s, &m_report.records}};
    }

    QSqlQuery *rowsOf(const QString &sql)
    {
        QSqlQuery *rows = m_database.run(sql);
        if (!rows) {
            m_report.problems.append(m_database.error());
        }
        return rows;
    }

    void readChunks()
    {
        QSqlQuery *rows = rowsOf(u"SELECT kind, data FROM chunk"_s);
        while (rows && rows->next()) {
            const QByteArray data = rows->value(1).toByteArray();
            if (rows->value(0).toInt() == static_cast<int>(ChunkKind::Samples)) {
                const auto chunk = decodeSampleChunk(data);
                m_report.samples += chunk ? static_cast<qint64>(chunk->x.size()) : 0;
                m_report.damaged += chunk ? 0 : 1;
            } else {
                const auto chunk = decodeReadingChunk(data);
                m_report.readings += chunk ? static_cast<qint64>(chunk->size()) : 0;
                m_report.damaged += chunk ? 0 : 1;
            }
        }
    }

    void readRollups()
    {
        QSqlQuery *rows = rowsOf(u"SELECT kind, data FROM rollup"_s);
        while (rows && rows->next()) {
            const auto kind = static_cast<ChunkKind>(rows->value(0).toInt());
            m_report.damaged += decodeRollup(rows->value(1).toByteArray(), kind) ? 0 : 1;
        }
    }

    void readTail()
    {
        QSqlQuery *rows = rowsOf(u"SELECT data FROM tail"_s);
        while (rows && rows->next()) {
            m_report.damaged += TailBatch::decode(rows->value(0).toByteArray()) ? 0 : 1;
        }
    }

    ArchiveDatabase m_database;
    ArchiveReport m_report;
};

} // namespace

std::optional<ArchiveReport> inspectArchive(const ArchiveConfig &config, QString *error)
{
    Inspection inspection(config);
    if (!inspection.open(error)) {
        return {};
    }
    inspection.count();
    inspection.readAll();
    return inspection.report();
}

std::optional<ArchiveReport> countArchive(const ArchiveConfig &config, QString *error)
{
    Inspection inspection(config);
    if (!inspection.open(error)) {
        return {};
    }
    inspection.count();
    return inspection.report();
}

bool backUpArchive(const ArchiveConfig &config, const QString &target, QString *error)
{
    Inspection inspection(config);
    if (!inspection.open(error)) {
        return false;
    }
    if (QFile::exists(target)) {
        *error = Inspection::tr("%1 is there already. Name another file.").arg(QDir::toNativeSeparators(target));
        return false;
    }
    const QString part = target + u".part"_s;
    QFile::remove(part);
    const bool isCopied = inspection.database().run(u"VACUUM INTO ?"_s, {part}) && QFile::rename(part, target);
    if (!isCopied) {
        *error = inspection.database().fault() == ArchiveFault::None
            ? Inspection::tr("%1 cannot be written.").arg(QDir::toNativeSeparators(target))
            : inspection.database().error();
        QFile::remove(part);
    }
    return isCopied;
}

} // namespace gorizont
