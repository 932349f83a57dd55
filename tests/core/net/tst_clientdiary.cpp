#include "core/net/clientdiary.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

QHostAddress address(const char *text)
{
    return QHostAddress(QString::fromLatin1(text));
}

} // namespace

/// What is told of those who come and go.
class TestClientDiary : public QObject
{
    Q_OBJECT

    const SteadyTime m_start{1h};

private Q_SLOTS:
    void aClientThatConnectsPerRequestIsToldOnce()
    {
        ClientDiary diary;
        int told = 0;
        for (int second = 0; second < 3600; ++second) {
            told += diary.arrives(address("10.0.0.1"), m_start + second * 1s) ? 1 : 0;
            diary.leaves(address("10.0.0.1"), m_start + second * 1s + 100ms);
            QVERIFY(diary.departures(m_start + second * 1s + 200ms).isEmpty());
        }
        QCOMPARE(told, 1);
    }

    void tellsOfADepartureAfterTenMinutes()
    {
        ClientDiary diary;
        QVERIFY(diary.arrives(address("10.0.0.1"), m_start));
        QVERIFY(!diary.arrives(address("10.0.0.1"), m_start)); // a second connection
        diary.leaves(address("10.0.0.1"), m_start + 1s);
        QVERIFY(diary.departures(m_start + 1h).isEmpty()); // one is still there
        diary.leaves(address("10.0.0.1"), m_start + 1h);
        QVERIFY(diary.departures(m_start + 1h + 10min - 1s).isEmpty());
        const auto gone = diary.departures(m_start + 1h + 10min);
        QCOMPARE(gone.size(), 1);
        QCOMPARE(gone.first().address, address("10.0.0.1"));
        QVERIFY(gone.first().left == m_start + 1h);
        QVERIFY(diary.departures(m_start + 2h).isEmpty());
        QVERIFY(diary.arrives(address("10.0.0.1"), m_start + 2h));
    }

    void tellsATroubleOnceUntilItRests()
    {
        ClientDiary diary;
        const QHostAddress client = address("10.0.0.1");
        QVERIFY(diary.isNews(ClientTrouble::Malformed, client, m_start));
        QVERIFY(diary.isNews(ClientTrouble::Refused, client, m_start));
        QVERIFY(diary.isNews(ClientTrouble::Malformed, address("10.0.0.2"), m_start));
        for (int minute = 1; minute < 60; ++minute) {
            QVERIFY(!diary.isNews(ClientTrouble::Malformed, client, m_start + minute * 1min));
            diary.departures(m_start + minute * 1min);
        }
        QVERIFY(diary.isNews(ClientTrouble::Malformed, client, m_start + 59min + 10min));
    }

    void isBounded()
    {
        ClientDiary diary;
        int told = 0;
        for (quint32 i = 0; i < 5000; ++i) {
            told += diary.arrives(QHostAddress(0x0A000000U + i), m_start) ? 1 : 0;
            told += diary.isNews(ClientTrouble::Refused, QHostAddress(0x0A000000U + i), m_start) ? 1 : 0;
            diary.leaves(QHostAddress(0x0A000000U + i), m_start);
        }
        QCOMPARE(told, 2 * ClientDiary::capacity);
        QCOMPARE(diary.departures(m_start + 10min).size(), ClientDiary::capacity);
        QVERIFY(diary.arrives(address("10.0.0.1"), m_start + 11min));
        QVERIFY(diary.isNews(ClientTrouble::Refused, address("10.0.0.1"), m_start + 11min));
    }
};

QTEST_APPLESS_MAIN(TestClientDiary)
#include "tst_clientdiary.moc"
