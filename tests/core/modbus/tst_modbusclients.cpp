#include "core/modbus/allowlist.h"
#include "core/modbus/clientdiary.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

QHostAddress address(const char *text)
{
    return QHostAddress(QString::fromLatin1(text));
}

} // namespace

/// Who may connect, and what of it is told.
class TestModbusClients : public QObject
{
    Q_OBJECT

    const SteadyTime m_start{1h};

private Q_SLOTS:
    void admits_data()
    {
        QTest::addColumn<QString>("list");
        QTest::addColumn<QString>("peer");
        QTest::addColumn<bool>("isAdmitted");
        const auto row = [](const char *list, const char *peer, bool isAdmitted) {
            QTest::addRow("[%s] %s", list, peer)
                << QString::fromLatin1(list) << QString::fromLatin1(peer) << isAdmitted;
        };
        row("", "10.1.2.3", true);
        row("", "2001:db8::1", true);
        row("10.1.2.3", "10.1.2.3", true);
        row("10.1.2.3", "10.1.2.4", false);
        row("10.1.2.3", "::ffff:10.1.2.3", true);
        row("192.168.1.0/24", "192.168.1.255", true);
        row("192.168.1.0/24", "192.168.2.0", false);
        row("192.168.1.0/24", "::ffff:192.168.1.7", true);
        row("192.168.1.0/24", "::c0a8:107", false);
        row("192.168.1.64/26", "192.168.1.63", false);
        row("192.168.1.64/26", "192.168.1.127", true);
        row("0.0.0.0/0", "8.8.8.8", true);
        row("0.0.0.0/0", "2001:db8::1", false);
        row("2001:db8::/32", "2001:db8:1::5", true);
        row("2001:db8::/32", "2001:db9::5", false);
        row("::1", "::1", true);
        row("::1", "127.0.0.1", false);
        row("10.0.0.1,  10.0.0.2 ", "10.0.0.2", true);
        row("nonsense", "10.0.0.2", false);
        row("nonsense,10.0.0.2", "10.0.0.2", true);
        row("10.0.0.0/33", "10.0.0.2", false);
        row(" ", "10.0.0.2", true);
    }

    void admits()
    {
        QFETCH(const QString, list);
        QFETCH(const QString, peer);
        const AllowList allowed(list.isEmpty() ? QStringList() : list.split(QLatin1Char(',')));
        QTEST(allowed.admits(plainAddress(QHostAddress(peer))), "isAdmitted");
    }

    void namesUnreadableEntries()
    {
        const AllowList allowed({QStringLiteral("10.0.0.0/8"), QStringLiteral("host"), QStringLiteral("1.2.3.4/99")});
        QCOMPARE(allowed.unreadable(), (QStringList{QStringLiteral("host"), QStringLiteral("1.2.3.4/99")}));
    }

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

QTEST_APPLESS_MAIN(TestModbusClients)
#include "tst_modbusclients.moc"
