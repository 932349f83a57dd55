#include "core/net/allowlist.h"

#include <QTest>

using namespace gorizont;

/// Who may connect.
class TestAllowList : public QObject
{
    Q_OBJECT

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
};

QTEST_APPLESS_MAIN(TestAllowList)
#include "tst_allowlist.moc"
