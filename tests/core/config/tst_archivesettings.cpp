#include "tests/core/config/configreading.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;

/// [Archive].
class TestArchiveSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAFileWithoutTheSection();
    void readsEveryKey();
    void complainsOfEveryMistake_data();
    void complainsOfEveryMistake();
};

void TestArchiveSettings::isAFileWithoutTheSection()
{
    const ArchiveSettings archive = read("[Common]\n").config.archive;
    QVERIFY(archive.isOn);
    QCOMPARE(archive.driver, ArchiveDriver::Sqlite);
    QCOMPARE(archive.file, QString());
    QCOMPARE(archive.keepRaw, 0);
    QCOMPARE(archive.mostSize, 0);
}

void TestArchiveSettings::readsEveryKey()
{
    const ConfigReading reading =
        read("[Common]\n[Archive]\nOn=0\nDriver=qpsql\nFile=a/b.sqlite\nHost=db\nPort=5433\nDatabase=towers\nUser=u\n"
             "PasswordFile=secret\nSite=tower "
             "1\nKeepRaw=400\nKeepSamples=30\nKeepRollups=4000\nKeepEvents=800\n");
    QCOMPARE(complaintTexts(reading), QStringList());
    const ArchiveSettings expected{
        false,
        ArchiveDriver::PostgreSql,
        u"a/b.sqlite"_s,
        u"db"_s,
        5433,
        u"towers"_s,
        u"u"_s,
        u"secret"_s,
        u"tower 1"_s,
        400,
        30,
        4000,
        800,
        0};
    QVERIFY(reading.config.archive == expected);
    QCOMPARE(read("[Common]\n[Archive]\nMostSize=500\n").config.archive.mostSize, 500);
}

void TestArchiveSettings::complainsOfEveryMistake_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const QByteArray &lines, const QString &complaint) {
        QTest::newRow(lines.constData()) << lines << u"[Archive] "_s + complaint;
    };
    row("Driver=Oracle", u"Driver, line 3: “Oracle” is none of QSQLITE, QPSQL. The default QSQLITE is used."_s);
    row("Driver=QPSQL", u"Driver, line 3: QPSQL needs Host and Database. The archive is a file, as with QSQLITE."_s);
    row("KeepRaw=-1", u"KeepRaw, line 3: “-1” is outside 0…36525. The default 0 is used."_s);
    row("MostSize=1", u"MostSize, line 3: An archive needs at least 16 MB. That size is used."_s);
    row("Driver=QPSQL\nHost=db\nDatabase=towers\nMostSize=500",
        u"MostSize, line 6: Only an archive of QSQLITE has it. It is ignored. KeepRaw and KeepSamples bound the archive."_s);
    const QString outlive =
        u"KeepRollups, line %1: Rollups cannot be removed before the readings of KeepRaw. They are kept as long as those."_s;
    row("KeepRollups=100", outlive.arg(3));
    row("KeepRaw=200\nKeepRollups=100", outlive.arg(4));
}

void TestArchiveSettings::complainsOfEveryMistake()
{
    QFETCH(const QByteArray, lines);
    QFETCH(const QString, complaint);
    QCOMPARE(complaintTexts(read("[Common]\n[Archive]\n" + lines + "\n")), QStringList{complaint});
}

QTEST_GUILESS_MAIN(TestArchiveSettings)

#include "tst_archivesettings.moc"
