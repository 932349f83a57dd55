#include "core/devices/usmisn/usmisnfetch.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;

/// Which transfers bring the records, whatever breaks off.
class TstUsmisnFetch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneTransferAChannel()
    {
        RecordFetch fetch(RecordMask::New);
        QCOMPARE(fetch.channel(), channelX);
        QVERIFY(fetch.mask() == RecordMask::New && !fetch.isAgain());
        fetch.record({});
        QCOMPARE(fetch.channel(), channelY);
        QVERIFY(fetch.mask() == RecordMask::New);
        fetch.record({});
        QVERIFY(fetch.isOver() && fetch.result());
    }

    /// What New has sent counts as read, so only All brings it again.
    void whatBrokeOffGoesOnWithAll_data()
    {
        QTest::addColumn<int>("fault");
        QTest::newRow("lost") << int(Fault::Timeout);
        QTest::newRow("damaged") << int(Fault::Checksum);
        QTest::newRow("unreadable") << int(Fault::BadReply);
    }
    void whatBrokeOffGoesOnWithAll()
    {
        QFETCH(int, fault);
        RecordFetch fetch(RecordMask::New);
        fetch.record(Fault(fault));
        QVERIFY(!fetch.isOver() && fetch.isAgain());
        QCOMPARE(fetch.channel(), channelX);
        QVERIFY(fetch.mask() == RecordMask::All);
        fetch.record({});
        QCOMPARE(fetch.channel(), channelY);
        QVERIFY(fetch.mask() == RecordMask::New && !fetch.isAgain()); // nothing of Y was sent
        fetch.record({});
        QVERIFY(fetch.result());
    }

    void givesUpAfterThree()
    {
        RecordFetch fetch(RecordMask::All, {channelY});
        for (int i = 0; i < 3; ++i) {
            QVERIFY(!fetch.isOver());
            fetch.record(Fault::Timeout);
        }
        QVERIFY(fetch.isOver() && !fetch.result());
        QVERIFY(fetch.result().fault() == Fault::Timeout);
    }

    void doesNotAskAgain_data()
    {
        QTest::addColumn<int>("fault");
        QTest::newRow("stopped") << int(Fault::Cancelled);
        QTest::newRow("refused") << int(Fault::Refused);
        QTest::newRow("the port is gone") << int(Fault::Closed);
    }
    void doesNotAskAgain()
    {
        QFETCH(int, fault);
        RecordFetch fetch(RecordMask::New);
        fetch.record(Fault(fault));
        QVERIFY(fetch.isOver());
        QVERIFY(fetch.result().fault() == Fault(fault));
    }
};

QTEST_GUILESS_MAIN(TstUsmisnFetch)
#include "tst_usmisnfetch.moc"
