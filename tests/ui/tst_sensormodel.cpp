#include "translations/translation.h"
#include "ui/models/sensormodel.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;

class TestSensorModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The headings are those of manual 000, section 4.3, with their units.
    void initTestCase() { QVERIFY(installTranslation(QStringLiteral("ru"))); }
    void init()
    {
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_model = std::make_unique<SensorModel>(*m_registry);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        const SteadyTime now = std::chrono::steady_clock::now();
        m_registry->updateLine(test::openLine(1, now));
        m_registry->updateLine(test::openLine(2, now));
        m_registry->update(
            {test::sampleReading(now), test::tiltReading(2, 36, -7200, now), test::tiltReading(3, -36000, 0, now)});
    }
    void cleanup()
    {
        m_tester.reset();
        m_model.reset();
        m_registry.reset();
    }

    /// Absent and invalid values are a dash, never a zero.
    void rows()
    {
        QCOMPARE(
            test::modelText(*m_model, true),
            QStringLiteral(
                "Датчик | Mx, ° | My, ° | Amax, мм/с² | Arms, мм/с² | T, °C | Частота, об./с | P, % | Статус\n"
                "1 АН-Д3 [Этаж 2] [12] | -1.000 | +0.756 | 7.67 | 2.19 | 21.38 | 41.0 | 45.3 |  0 0000 0000 0000\n"
                "2 ИН-Д3 [24] | +0.010 | -2.000 | — | — | — | — | — |  0 0011 0000 0000\n"
                "3 ИН-Д3 [5] | -10.000 | +0.000 | — | — | — | — | — |  0 0011 0000 0000\n"
                "4 ИН-Д3 [6] | — | — | — | — | — | — | — |  0 1111 0000 0000"));
    }

    void sortsNumbersWithAbsentLast()
    {
        m_model->sort(SensorModel::Mx, Qt::AscendingOrder);
        QCOMPARE(numbers(), QList<int>({3, 1, 2, 4}));
        m_model->sort(SensorModel::Mx, Qt::DescendingOrder);
        QCOMPARE(numbers(), QList<int>({2, 1, 3, 4}));
        m_model->sort(SensorModel::Status, Qt::DescendingOrder);
        QCOMPARE(numbers(), QList<int>({4, 2, 3, 1}));
        m_model->sort(-1);
        QCOMPARE(numbers(), QList<int>({1, 2, 3, 4}));
    }

    void fanAndHeaterOfNoThermostatAreAbsent()
    {
        Reading reading = test::tiltReading(2, 36, 0, std::chrono::steady_clock::now());
        reading.heaterPower = 0;
        reading.fanFrequency = 0;
        m_registry->update({reading});
        QCOMPARE(m_model->index(1, SensorModel::Fan).data().toString(), QStringLiteral("—"));
        QCOMPARE(m_model->index(1, SensorModel::Power).data().toString(), QStringLiteral("—"));
    }

    /// What every bit of manual 000, section 11.2, means.
    void toolTips()
    {
        QCOMPARE(
            toolTip(0, SensorModel::Sensor),
            QStringLiteral("1 АН-Д3 [Этаж 2] [12]\nАН1 (АН-Д3, TMP05, подогрев)\nCOM4: Отвечает"));
        QCOMPARE(toolTip(0, SensorModel::Mx), QStringLiteral("-3599.5 угл. сек."));
        QCOMPARE(toolTip(0, SensorModel::Amax), QStringLiteral("по X -0.00, по Y -7.67 мм/с²"));
        QCOMPARE(toolTip(0, SensorModel::Arms), QStringLiteral("по X +0.00, по Y +2.19 мм/с²"));
        Reading reading = test::sampleReading(std::chrono::steady_clock::now());
        reading.status = 0xAFFC;
        m_registry->update({reading});
        QCOMPARE(
            toolTip(0, SensorModel::Status),
            QStringLiteral("код 10: Не работает вентилятор\n"
                           "бит 11: опрос отключен\n"
                           "бит 10: результаты измерения углов наклона не достоверны или не готовы\n"
                           "бит 9: результаты измерения температуры не достоверны или не готовы\n"
                           "бит 8: результаты измерения ускорений не достоверны или не готовы\n"
                           "бит 7: переполнение буфера обмена ускорений\n"
                           "бит 6: ошибка синхронизации\n"
                           "бит 5: произошла перезагрузка микроконтроллера\n"
                           "бит 4: терморегулирование не завершено\n"
                           "бит 3: минимальная мощность нагрева термостата (быстрое охлаждение)\n"
                           "бит 2: максимальная мощность нагрева термостата (быстрый нагрев)"));
        QCOMPARE(m_model->headerData(SensorModel::Status, Qt::Horizontal, Qt::ToolTipRole).toString().count(u'\n'), 10);
    }

    void selectionStaysWithItsSensor()
    {
        const QPersistentModelIndex second(m_model->index(1, SensorModel::My));
        m_model->sort(SensorModel::Mx, Qt::DescendingOrder);
        QCOMPARE(second.row(), 0);
        QCOMPARE(second.data().toString(), QStringLiteral("-2.000"));
        QCOMPARE(m_model->rowOf(1), 0);
    }

    void resortsWhenValuesMove()
    {
        m_model->sort(SensorModel::Mx, Qt::AscendingOrder);
        QSignalSpy moved(m_model.get(), &QAbstractItemModel::layoutChanged);
        m_model->resort();
        QCOMPARE(moved.size(), 0);
        m_registry->update({test::tiltReading(3, 36000, 0, std::chrono::steady_clock::now())});
        m_model->resort();
        QCOMPARE(moved.size(), 1);
        QCOMPARE(numbers(), QList<int>({1, 2, 3, 4}));
    }

    /// However many sensors change, only what is looked at is drawn.
    void announcesOnlyTheRowsAskedFor()
    {
        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        m_registry->update({test::tiltReading(2, 1, 1, std::chrono::steady_clock::now())});
        QCOMPARE(changed.size(), 0);
        m_model->refresh(1, 2);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed.at(0).at(0).toModelIndex(), m_model->index(1, 0));
        QCOMPARE(changed.at(0).at(1).toModelIndex(), m_model->index(2, SensorModel::Status));
        m_model->refresh(0, -1);
        QCOMPARE(changed.size(), 1);
    }

private:
    QString toolTip(int row, int column) const { return m_model->index(row, column).data(Qt::ToolTipRole).toString(); }

    QList<int> numbers() const
    {
        QList<int> list;
        for (int row = 0; row < m_model->rowCount(); ++row) {
            list += m_registry->sensors()[static_cast<std::size_t>(m_model->sensorAt(row))].config.number;
        }
        return list;
    }

    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<SensorModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

QTEST_MAIN(TestSensorModel)
#include "tst_sensormodel.moc"
