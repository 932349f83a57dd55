#include "core/archive/spoolfile.h"
#include "tests/core/archive/failingdisk.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

/// A disk that does not give back what is on it.
class TestSpoolRead : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void anErrorIsNoTornEnd();
    void anErrorIsNotTheEnd();

private:
    // The name for which failingdisk.cpp stands in.
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite.spool")); }
    QList<QByteArray> batches(SpoolFile &spool) const
    {
        QList<QByteArray> all;
        qint64 at = 0;
        while (const auto entry = spool.read(at)) {
            all.append(entry->batch);
            at = entry->end;
        }
        return all;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QList<QByteArray> m_written;
};

void TestSpoolRead::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_written.clear();
    SpoolFile spool(file(), 1 << 20);
    QVERIFY(spool.open());
    for (int i = 0; i < 5; ++i) {
        m_written.append(QByteArray(100 + i, static_cast<char>('a' + i)));
        QVERIFY(spool.append(m_written.last()));
    }
}

/// Whichever read fails while the file is opened, all of it is there the next time.
void TestSpoolRead::anErrorIsNoTornEnd()
{
    const qint64 size = QFileInfo(file()).size();
    int failures = 0;
    for (int nth = 1; nth < 100; ++nth) {
        SpoolFile spool(file(), 1 << 20);
        {
            const FailingDisk disk(DiskCall::Read, nth);
            const bool isOpen = spool.open();
            QCOMPARE(isOpen, !disk.hasFailed());
            failures += disk.hasFailed() ? 1 : 0;
        }
        QCOMPARE(QFileInfo(file()).size(), size);
        QVERIFY(spool.isOpen() || (!spool.error().isEmpty() && spool.open()));
        QCOMPARE(batches(spool), m_written);
        QCOMPARE(spool.next().sequence, 6);
    }
    QVERIFY2(failures >= 10, qPrintable(QString::number(failures))); // head and batch of each
}

void TestSpoolRead::anErrorIsNotTheEnd()
{
    SpoolFile spool(file(), 1 << 20);
    QVERIFY(spool.open());
    {
        const FailingDisk disk(DiskCall::Read, 3); // the head of the second
        QCOMPARE(batches(spool), m_written.first(1));
        QVERIFY(disk.hasFailed());
    }
    QVERIFY(spool.isUnreadable());
    QCOMPARE(batches(spool), m_written);
    QVERIFY(!spool.isUnreadable());
}

QTEST_GUILESS_MAIN(TestSpoolRead)

#include "tst_spoolread.moc"
