#include "core/station/service/receivedfile.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont::station;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(none)");
}

} // namespace

class TestReceivedFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refuses_data();
    void refuses();
    void storesWhatAStationReads_data();
    void storesWhatAStationReads();
    void keepsTheOldOne();
    void replacesTheFileThatIsThere();
    void leavesTheOldOneWhenItCannotWrite();
};

void TestReceivedFile::refuses_data()
{
    QTest::addColumn<QByteArray>("name");
    for (const char *name :
         {"",
          "ACK",
          "ACK.EXE",
          "ACK.SRC",
          "ack.src",
          "../ACK.PAR",
          "/etc/ACK.PAR",
          "sub/ACK.PAR",
          "..\\ACK.PAR",
          "C:ACK.PAR",
          "ACK.PAR.BAK",
          "INPUT.P1",
          "INPUT.P0A",
          "INPUT.PP1",
          "INPUT.P011",
          "OTHER.P01",
          ".INPUT.P01",
          "../INPUT.P01",
          "passwd",
          "clock.txt",
          "2026_11_obj001.txt",
          "ACK.PAR\n",
          " ACK.PAR"}) {
        QTest::newRow(name) << QByteArray(name);
    }
    QTest::newRow("zero byte") << QByteArray("ACK.PAR\0x", 9);
    QTest::newRow("zero byte first") << QByteArray("\0ACK.PAR", 8);
}

void TestReceivedFile::refuses()
{
    QFETCH(QByteArray, name);
    QTemporaryDir outer;
    const QString folder = outer.filePath(QStringLiteral("station"));
    QVERIFY(QDir().mkpath(folder + QStringLiteral("/sub")));
    QVERIFY(!storeReceivedFile(folder, name, "1").problem.isEmpty());
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden), QStringList());
    QCOMPARE(QDir(outer.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
    QCOMPARE(QDir(folder + QStringLiteral("/sub")).entryList(QDir::Files | QDir::Hidden), QStringList());
}

void TestReceivedFile::storesWhatAStationReads_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("stored");
    QTest::newRow("capitals") << QByteArray("ACK.INI") << QStringLiteral("ACK.INI");
    QTest::newRow("small") << QByteArray("ack.gam") << QStringLiteral("ACK.GAM");
    QTest::newRow("correction") << QByteArray("Input.p01") << QStringLiteral("INPUT.P01");
    QTest::newRow("Cyrillic, CP866") << QByteArray("\x80\x91\x8A.PAR") << QStringLiteral("ACK.PAR");
    QTest::newRow("Cyrillic, Windows-1251") << QByteArray("\xC0\xD1\xCA.PSE") << QStringLiteral("ACK.PSE");
}

void TestReceivedFile::storesWhatAStationReads()
{
    QFETCH(QByteArray, name);
    QFETCH(QString, stored);
    QTemporaryDir folder;
    const ReceivedFile received = storeReceivedFile(folder.path(), name, "new");
    QCOMPARE(received.problem, QString());
    QCOMPARE(received.name, stored);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{stored});
    QCOMPARE(contentOf(folder.filePath(stored)), QByteArray("new"));
}

void TestReceivedFile::keepsTheOldOne()
{
    QTemporaryDir folder;
    QVERIFY(storeReceivedFile(folder.path(), "ACK.PAR", "first").problem.isEmpty());
    QVERIFY(storeReceivedFile(folder.path(), "ACK.PAR", "second").problem.isEmpty());
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("ACK.PAR"))), QByteArray("second"));
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("ACK.PAR.bak"))), QByteArray("first"));
}

/// However its name is written, for the station would complain about a second one.
void TestReceivedFile::replacesTheFileThatIsThere()
{
    QTemporaryDir folder;
    const QString cyrillic = QString::fromUtf8("аск.Par");
    QFile old(folder.filePath(cyrillic));
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    QVERIFY(storeReceivedFile(folder.path(), "ACK.PAR", "new").problem.isEmpty());
    QCOMPARE(contentOf(folder.filePath(cyrillic)), QByteArray("new"));
    QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("ACK.PAR"))));
}

/// Also as root, whom rights do not stop: a folder stands where the copy of the old file would go.
void TestReceivedFile::leavesTheOldOneWhenItCannotWrite()
{
    QTemporaryDir folder;
    QVERIFY(storeReceivedFile(folder.path(), "ACK.PAR", "old").problem.isEmpty());
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ACK.PAR.bak/x")));
    QVERIFY(!storeReceivedFile(folder.path(), "ACK.PAR", "new").problem.isEmpty());
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("ACK.PAR"))), QByteArray("old"));
    QVERIFY(!storeReceivedFile(folder.filePath(QStringLiteral("nowhere")), "ACK.PAR", "new").problem.isEmpty());
}

QTEST_GUILESS_MAIN(TestReceivedFile)

#include "tst_receivedfile.moc"
