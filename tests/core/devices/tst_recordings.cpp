#include "tests/support/talk.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

/// Plays every tests/data/*/*.talk: a new recording needs no C++.
class TstRecordings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void play_data();
    void play();
    void aRecordingCanFail_data();
    void aRecordingCanFail();
};

void TstRecordings::play_data()
{
    QTest::addColumn<QString>("path");
    const QDir data(QStringLiteral(GORIZONT_TEST_DATA));
    QDirIterator it(data.path(), {QStringLiteral("*.talk")}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QString path = it.next();
        QTest::newRow(qPrintable(data.relativeFilePath(path))) << path;
    }
}

void TstRecordings::play()
{
    QFETCH(QString, path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList findings = playTalk(parseTalk(file.readAll()));
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(u'\n')));
}

void TstRecordings::aRecordingCanFail_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("finding");

    const QByteArray sensor("@ name ИН-Д3\n@ address 1\n");
    const QByteArray sent("> 7E 9B 01 01 9B 7E\n");
    const QByteArray received("< 7E 9B 01 01 6A 77 80 38 C2 00 FC 7E\n");
    QTest::newRow("value") << sensor + sent + received + "= tiltX 194.220"
                           << QStringLiteral("line 5: tiltX: expected 194.220, got 194.219");
    QTest::newRow("absent value") << sensor + sent + received + "= temperature 20"
                                  << QStringLiteral("line 5: temperature: expected 20, got none");
    QTest::newRow("no value though expected")
        << sensor + sent + "= tiltX 1" << QStringLiteral("line 4: tiltX: expected 1, got fault Timeout");
    QTest::newRow("fault") << sensor + sent + received + "= fault Timeout"
                           << QStringLiteral("line 5: fault: expected Timeout, got a measurement");
    QTest::newRow("unknown key") << sensor + sent + received + "= tilt 1"
                                 << QStringLiteral("line 5: tilt: expected 1, got ?");
    QTest::newRow("blocks") << sensor + sent + received + "= tiltX 194.219\n= blocks 2"
                            << QStringLiteral("line 6: blocks: expected 2, got no backlog");
    QTest::newRow("other request") << sensor + "> 7E 9B 01 02 98 7E\n" + received + "= fault Timeout"
                                   << QStringLiteral("line 5: expected 7e 9b 01 02 98 7e got 7e 9b 01 01 9b 7e");
    QTest::newRow("more requests recorded") << sensor + sent + received + sent + "= tiltX 194.219"
                                            << QStringLiteral("line 6: the driver sent less than was recorded");
    QTest::newRow("not hexadecimal") << sensor + "> 7E 9B 01 0G\n= fault Timeout"
                                     << QStringLiteral("line 3 is not understood: > 7E 9B 01 0G");
    QTest::newRow("answer before a request") << sensor + received + sent
            + "= fault Timeout" << QStringLiteral("line 3 is not understood: < 7E 9B 01 01 6A 77 80 38 C2 00 FC 7E");
    QTest::newRow("nothing expected") << sensor + sent + received
                                      << QStringLiteral("the last exchange has no expectation");
    QTest::newRow("no driver") << "@ name what\n" + sent + "= fault Timeout"
                               << QStringLiteral("no driver for the sensor \"what\"");
}

void TstRecordings::aRecordingCanFail()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, finding);
    QCOMPARE(playTalk(parseTalk(text)), QStringList{finding});
}

QTEST_GUILESS_MAIN(TstRecordings)
#include "tst_recordings.moc"
