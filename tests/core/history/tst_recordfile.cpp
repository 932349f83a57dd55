#include "core/files/recordfile.h"
#include "core/history/logfile.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using State = RecordFile::State;

namespace {

const QString openedRecord = QStringLiteral("1 18:33:03 07.02.18   COM4 открыт\r\n");
const QString silentRecord = QStringLiteral("3 18:33:04 07.02.18   Датчик 2 не отвечает\r\n");

} // namespace

class TestRecordFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void appendsAtOnceToWhatIsThere();
    void createsTheFolder();
    void cutsAnUnfinishedRecordOnce_data();
    void cutsAnUnfinishedRecordOnce();
    void shortWriteLeavesNoTrace();
    void movesToAnotherFile();
    void comesBackAfterRemoval_data();
    void comesBackAfterRemoval();
    void foreignTailIsFollowedByAWholeRecord();
    void impossibleFolderIsNamed();
    void newLogIsUtf8();
    void logInWindows1251IsContinued();
    void logReplacedByANewOneIsUtf8Again();
    void longUtf8LogIsRecognized();

private:
    QString path() const { return m_folder->filePath(QStringLiteral("2018_02_data.txt")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestRecordFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestRecordFile::appendsAtOnceToWhatIsThere()
{
    writeAll(path(), "old\r\n");
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("one\r\n"));
    QCOMPARE(readAll(path()), "old\r\none\r\n"); // the file is still open
    QCOMPARE(file.prepare(path()), State::Ready);
    QVERIFY(file.append("two\r\n"));
    QCOMPARE(readAll(path()), "old\r\none\r\ntwo\r\n");
    QVERIFY(!file.takeRepaired());
}

void TestRecordFile::createsTheFolder()
{
    RecordFile file;
    const QString deep = m_folder->filePath(QStringLiteral("a/b/History/x.txt"));
    QCOMPARE(file.prepare(deep), State::Opened);
    QVERIFY(file.append("one\r\n"));
    QCOMPARE(readAll(deep), "one\r\n");
}

void TestRecordFile::cutsAnUnfinishedRecordOnce_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<bool>("isRepaired");
    const QByteArray big(200'000, 'x');
    QTest::newRow("empty") << QByteArray() << QByteArray() << false;
    QTest::newRow("whole") << QByteArray("a\r\nb\r\n") << QByteArray("a\r\nb\r\n") << false;
    QTest::newRow("half a record") << QByteArray("a\r\nbb") << QByteArray("a\r\n") << true;
    QTest::newRow("only LF is missing") << QByteArray("a\r\nb\r") << QByteArray("a\r\n") << true;
    QTest::newRow("nothing whole") << QByteArray("abc") << QByteArray() << true;
    QTest::newRow("zeros of a power cut")
        << QByteArray("a\r\n") + QByteArray(5000, '\0') << QByteArray("a\r\n") << true;
    QTest::newRow("an editor took the CR away") << QByteArray("a\nb\n") << QByteArray("a\nb\n") << false;
    QTest::newRow("a long unfinished record") << "a\r\n" + big << QByteArray("a\r\n") << true;
    QTest::newRow("a long whole record") << big + "\r\nb" << big + "\r\n" << true;
}

void TestRecordFile::cutsAnUnfinishedRecordOnce()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    writeAll(path(), before);
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QTEST(file.takeRepaired(), "isRepaired");
    QVERIFY(!file.takeRepaired());
    QVERIFY(file.append("new\r\n"));
    QCOMPARE(readAll(path()), after + "new\r\n");
}

void TestRecordFile::shortWriteLeavesNoTrace()
{
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("0123456\r\n"));
    {
        const FileSizeLimit limit(13); // four bytes of the next record fit
        QVERIFY(!file.append("abcdefg\r\n"));
    }
    QCOMPARE(readAll(path()), "0123456\r\n");
    QVERIFY2(file.error().startsWith(u"2018_02_data.txt: "), qPrintable(file.error()));
    QVERIFY2(!file.error().contains(u"Unknown"), qPrintable(file.error()));
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("abcdefg\r\n"));
    QCOMPARE(readAll(path()), "0123456\r\nabcdefg\r\n");
    QVERIFY(!file.takeRepaired());
}

void TestRecordFile::movesToAnotherFile()
{
    const QString march = m_folder->filePath(QStringLiteral("2018_03_data.txt"));
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("february\r\n"));
    QCOMPARE(file.prepare(march), State::Opened);
    QVERIFY(file.append("march\r\n"));
    QCOMPARE(readAll(path()), "february\r\n");
    QCOMPARE(readAll(march), "march\r\n");
}

void TestRecordFile::comesBackAfterRemoval_data()
{
    QTest::addColumn<QByteArray>("replacement");
    QTest::addColumn<QByteArray>("expected");
    QTest::newRow("removed") << QByteArray() << QByteArray("two\r\n");
    QTest::newRow("replaced") << QByteArray("other\r\n") << QByteArray("other\r\ntwo\r\n");
}

void TestRecordFile::comesBackAfterRemoval()
{
    QFETCH(QByteArray, replacement);
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("one\r\n"));
    QVERIFY(QFile::rename(path(), path() + QStringLiteral(".old")));
    if (!replacement.isEmpty()) {
        writeAll(path(), replacement);
    }
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("two\r\n"));
    QTEST(readAll(path()), "expected");
    QCOMPARE(readAll(path() + QStringLiteral(".old")), "one\r\n");
}

void TestRecordFile::foreignTailIsFollowedByAWholeRecord()
{
    RecordFile file;
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("one\r\n"));
    QFile other(path());
    QVERIFY(other.open(QIODevice::Append));
    other.write("note\r\nhalf");
    other.close();
    QCOMPARE(file.prepare(path()), State::Opened);
    QVERIFY(file.append("two\r\n"));
    QCOMPARE(readAll(path()), "one\r\nnote\r\ntwo\r\n");
}

/// A file where the folder should be stops even an administrator.
void TestRecordFile::impossibleFolderIsNamed()
{
    const QString folder = m_folder->filePath(QStringLiteral("History"));
    writeAll(folder, "a file");
    RecordFile file;
    QCOMPARE(file.prepare(folder + QStringLiteral("/x.txt")), State::Failed);
    QVERIFY2(file.error().contains(QDir::toNativeSeparators(folder)), qPrintable(file.error()));
    QVERIFY(QFile::remove(folder));
    QCOMPARE(file.prepare(folder + QStringLiteral("/x.txt")), State::Opened);
}

void TestRecordFile::newLogIsUtf8()
{
    LogFile log;
    QVERIFY(log.append(path(), openedRecord));
    QVERIFY(log.append(path(), silentRecord));
    QCOMPARE(readAll(path()), expectedFile("utf8_log.txt"));
}

void TestRecordFile::logInWindows1251IsContinued()
{
    const QByteArray whole = expectedFile("windows1251_log.txt");
    writeAll(path(), whole.left(whole.indexOf('\n') + 1));
    LogFile log;
    QVERIFY(log.append(path(), openedRecord));
    QVERIFY(log.append(path(), silentRecord));
    QCOMPARE(readAll(path()), whole);
}

void TestRecordFile::logReplacedByANewOneIsUtf8Again()
{
    const QByteArray whole = expectedFile("windows1251_log.txt");
    writeAll(path(), whole.left(whole.indexOf('\n') + 1));
    LogFile log;
    QVERIFY(log.append(path(), openedRecord));
    QVERIFY(QFile::remove(path()));
    QVERIFY(log.append(path(), openedRecord));
    QVERIFY(log.append(path(), silentRecord));
    QCOMPARE(readAll(path()), expectedFile("utf8_log.txt"));
}

/// Letters of two bytes lie across every border of the pieces in which the file is read.
void TestRecordFile::longUtf8LogIsRecognized()
{
    const QByteArray old = QByteArray("x") + QStringLiteral("ж").repeated(100'000).toUtf8() + "\r\n";
    writeAll(path(), old);
    LogFile log;
    QVERIFY(log.append(path(), openedRecord));
    QCOMPARE(readAll(path()), old + openedRecord.toUtf8());
}

QTEST_GUILESS_MAIN(TestRecordFile)
#include "tst_recordfile.moc"
