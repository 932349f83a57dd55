#include "core/line/openline.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

class TestOpenLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void deviceName_data()
    {
        QTest::addColumn<QString>("device");
        QTest::addColumn<QString>("directory");
        QTest::addColumn<QString>("expected");
        QTest::newRow("by number") << QString() << QString() << QStringLiteral("/dev/ttyS9");
        QTest::newRow("--ports") << QString() << QStringLiteral("/run/p") << QStringLiteral("/run/p/COM10");
        QTest::newRow("Device wins") << QStringLiteral("/dev/x") << QStringLiteral("/run/p")
                                     << QStringLiteral("/dev/x");
    }

    void deviceName()
    {
        QFETCH(QString, device);
        QFETCH(QString, directory);
        LineConfig line;
        line.com = 10;
        line.device = device;
        QTEST(gorizont::deviceName(line, {directory}), "expected");
    }

    void aPortThatIsNotThereSaysWhy()
    {
        LineConfig line;
        line.device = QStringLiteral("/nonexistent/port");
        const auto made = makeLine(line, {}, 100ms);
        QVERIFY(made);
        const auto opened = made->open();
        QVERIFY(!opened);
        QCOMPARE(opened.fault(), Fault::Closed);
        QVERIFY(!made->lastError().text.isEmpty());
    }

    void nobodyListens()
    {
        LineConfig line;
        line.device = QStringLiteral("tcp://127.0.0.1:1");
        const auto made = makeLine(line, {}, 100ms);
        QVERIFY(made);
        QVERIFY(!made->open());
        QVERIFY(!made->isOpen());
    }

    void simulatedLinesAreMadeElsewhere()
    {
        LineConfig line;
        line.device = QStringLiteral("sim:");
        QVERIFY(!makeLine(line, {}, 100ms));
    }
};

QTEST_GUILESS_MAIN(TestOpenLine)
#include "tst_openline.moc"
