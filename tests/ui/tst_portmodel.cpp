#include "translations/translation.h"
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
    /// The headings are those of manual 000, section 4.2.
    void initTestCase() { QVERIFY(installTranslation(QStringLiteral("ru"))); }

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
            QStringLiteral("Порт | Состояние | Время | Отправлено | Принято | Попыток\n"
                           "COM4 | Открыт, идёт опрос | 0:03:58 | 12345 | 9876543210 | 0\n"
                           "COM9 | Не открывается | — | 0 | 0 | 7\n"
                           "COM2 | Выключен | — | 0 | 0 | 0"));
    }

    void everyHeadingExplainsItself()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const PortModel model(registry);
        for (int column = 0; column < model.columnCount(); ++column) {
            QVERIFY(!model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
        }
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
