#include "core/history/historyinbox.h"
#include "tests/core/history/historysupport.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

class TestHistoryInbox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyTheLastReadingOfEachSensorIsKept();
    void onlyTheLastStateOfEachPortIsKept();
    void oldestSamplesAreDroppedAndTheGapShows();
    void oneBlockOverTheLimitIsKept();
    void oldestEventsAreDropped();
    void oldestCapturesAreDropped();
    void writerIsWokenOnce();
    void tellsHowMuchWaits();
};

void TestHistoryInbox::onlyTheLastReadingOfEachSensorIsKept()
{
    HistoryInbox inbox(64);
    Reading first;
    first.number = 1;
    Reading second = first;
    second.status = 0x0700;
    Reading other;
    other.number = 2;
    inbox.put(Readings{first, other});
    inbox.put(Readings{second});
    const HistoryInbox::Contents contents = inbox.take();
    QCOMPARE(contents.readings.size(), 2);
    QVERIFY(contents.readings.value(1) == second);
    QVERIFY(inbox.take().readings.isEmpty());
}

void TestHistoryInbox::onlyTheLastStateOfEachPortIsKept()
{
    HistoryInbox inbox(64);
    LineStatus status;
    status.port = 3;
    inbox.put(status);
    status.state = LineState::Lost;
    inbox.put(status);
    const HistoryInbox::Contents contents = inbox.take();
    QCOMPARE(contents.lines.size(), 1);
    QVERIFY(contents.lines.value(3).state == LineState::Lost);
}

void TestHistoryInbox::oldestSamplesAreDroppedAndTheGapShows()
{
    HistoryInbox inbox(64);
    for (int i = 0; i < 5; ++i) {
        (void)inbox.put(samples(1, {}, static_cast<qint16>(32 * i), 32));
        (void)inbox.put(samples(2, {}, 0, 8));
    }
    const HistoryInbox::Contents contents = inbox.take();
    const QList<SampleBlock> kept = contents.blocks.value(1);
    QCOMPARE(kept.size(), 2);
    QCOMPARE(kept.at(0).x.first(), qint16(96));
    QVERIFY(!kept.at(0).followsPrevious);
    QVERIFY(kept.at(1).followsPrevious);
    QCOMPARE(contents.blocks.value(2).size(), 5);
    QVERIFY(contents.blocks.value(2).first().followsPrevious);
    QCOMPARE(contents.samplesDropped, 96);
    QCOMPARE(inbox.take().samplesDropped, 0);
}

void TestHistoryInbox::oneBlockOverTheLimitIsKept()
{
    HistoryInbox inbox(4);
    (void)inbox.put(samples(1, {}, 0, 32));
    QCOMPARE(inbox.take().blocks.value(1).size(), 1);
}

void TestHistoryInbox::oldestEventsAreDropped()
{
    HistoryInbox inbox(64);
    for (int i = 0; i < HistoryInbox::mostEntries + 3; ++i) {
        (void)inbox.put(JournalEntry{JournalKind::Info, {}, QString::number(i)});
    }
    const HistoryInbox::Contents contents = inbox.take();
    QCOMPARE(contents.entries.size(), HistoryInbox::mostEntries);
    QCOMPARE(contents.entries.first().text, u"3");
    QCOMPARE(contents.entriesDropped, 3);
}

void TestHistoryInbox::oldestCapturesAreDropped()
{
    HistoryInbox inbox(64);
    SignalCapture captured;
    captured.codes.resize(HistoryInbox::mostCodes / 2);
    for (captured.number = 1; captured.number <= 3; ++captured.number) {
        (void)inbox.put(captured);
    }
    const HistoryInbox::Contents contents = inbox.take();
    QCOMPARE(contents.captures.size(), 2);
    QCOMPARE(contents.captures.first().number, 2);
    QCOMPARE(contents.capturesDropped, 1);
    captured.codes.resize(HistoryInbox::mostCodes + 1);
    (void)inbox.put(captured); // one waits however long it is
    QCOMPARE(inbox.take().captures.size(), 1);
}

void TestHistoryInbox::writerIsWokenOnce()
{
    HistoryInbox inbox(64);
    QVERIFY(inbox.put(JournalEntry()));
    QVERIFY(!inbox.put(samples(1, {}, 0, 1)));
    (void)inbox.take();
    QVERIFY(inbox.put(samples(1, {}, 0, 1)));
}

void TestHistoryInbox::tellsHowMuchWaits()
{
    HistoryInbox inbox(64);
    const UtcTime start = moscow("2018-02-07T18:33:03");
    QCOMPARE(inbox.backlog().samples, 0);
    QVERIFY(inbox.put(samples(1, start, 0, 32)));
    QVERIFY(!inbox.put(samples(2, start, 0, 10)));
    QVERIFY(!inbox.put(JournalEntry{JournalKind::Info, start, QStringLiteral("text")}));
    QCOMPARE(inbox.backlog().samples, 42);
    QCOMPARE(inbox.backlog().entries, 1);
    inbox.take();
    QCOMPARE(inbox.backlog().samples, 0);
    QCOMPARE(inbox.backlog().entries, 0);
}

QTEST_GUILESS_MAIN(TestHistoryInbox)
#include "tst_historyinbox.moc"
