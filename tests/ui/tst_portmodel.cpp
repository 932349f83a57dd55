#include "ui/models/portmodel.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

class TestPortModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rows()
    {
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        PortModel model(registry);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const SteadyTime now = std::chrono::steady_clock::now();
        LineStatus open = test::openLine(1, now);
        open.bytesSent = 12345;
        open.bytesReceived = 9876543210;
        LineStatus failed;
        failed.port = 2;
        failed.state = LineState::OpenFailed;
        failed.failedOpens = 7;
        registry.updateLine(open);
        registry.updateLine(failed);

        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        model.refresh(now + 238s);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(
            test::modelText(model, true),
            QStringLiteral("Port | State | Time | Sent | Received | Attempts\n"
                           "COM4 | Open, polling | 0:03:58 | 12345 | 9876543210 | 0\n"
                           "COM9 | Cannot be opened | — | 0 | 0 | 7\n"
                           "COM2 | Off | — | 0 | 0 | 0"));
    }

    void noPorts()
    {
        const SensorRegistry registry({}, StatusRules());
        PortModel model(registry);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.refresh(std::chrono::steady_clock::now());
        QCOMPARE(model.rowCount(), 0);
    }
};

QTEST_MAIN(TestPortModel)
#include "tst_portmodel.moc"
