#include "translations/translation.h"
#include "ui/models/measurementmodel.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QFontDatabase>
#include <QtTest>

using namespace gorizont;

namespace {

// spec/gorizont.md, section 3: the sample line, two sensors
const QString sample = QStringLiteral("18:33:03 07.02.18\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0011 0011 1000"
                                      "\t -3599.5\t -3599.5\t   21.38\t     0.0\t 0 0000 0001 1000");

QString firstFields(const QAbstractItemModel &model)
{
    QString text;
    for (int row = 0; row < model.rowCount(); ++row) {
        text += model.index(row, 0).data().toString();
    }
    return text;
}

} // namespace

class TestMeasurementModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneFieldAColumn()
    {
        ServerConfig config = test::sampleConfig();
        config.lines.removeLast();
        config.lines.removeLast();
        const SensorRegistry registry(config.lines, StatusRules());
        MeasurementModel model(registry, 60, 1);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.append(sample + QStringLiteral("\r\n"));
        QCOMPARE(
            test::modelText(model, true),
            QStringLiteral("Time | Ports | 1: X, ″ | 1: Y, ″ | 1: T, °C | 1: P, % | 1: status"
                           " | 2: X, ″ | 2: Y, ″ | 2: T, °C | 2: P, % | 2: status\n")
                + QString(sample).replace(u'\t', QStringLiteral(" | ")));
    }

    void headingsExplainThemselves()
    {
        QVERIFY(installTranslation(QStringLiteral("ru")));
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const MeasurementModel model(registry, 60, 1);
        QStringList notes;
        for (int column = 0; column < 7; ++column) {
            notes += model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
        }
        QCOMPARE(
            notes.join(u'\n'),
            QStringLiteral("Время и дата записи\n"
                           "Слово состояния канала, первый порт справа: 0 — нет ошибок, 1 — не открывается, "
                           "2 — ошибки записи, 3 — опрос отключен или порта нет\n"
                           "1 АН-Д3 [Этаж 2] [12]: угол наклона по X, угл. сек.\n"
                           "1 АН-Д3 [Этаж 2] [12]: угол наклона по Y, угл. сек.\n"
                           "1 АН-Д3 [Этаж 2] [12]: температура, °C; пусто, если датчик её не измеряет\n"
                           "1 АН-Д3 [Этаж 2] [12]: мощность нагревательного элемента термостата, %\n"
                           "1 АН-Д3 [Этаж 2] [12]: слово состояния датчика, код и биты 11…0"));
    }

    void isMonospaced()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        MeasurementModel model(registry, 60, 1);
        model.append(sample);
        QCOMPARE(
            model.index(0, 0).data(Qt::FontRole).value<QFont>(), QFontDatabase::systemFont(QFontDatabase::FixedFont));
    }

    void shortLineHasEmptyFields()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        MeasurementModel model(registry, 60, 1);
        model.append(QStringLiteral("a\tb"));
        QCOMPARE(model.index(0, 1).data().toString(), QStringLiteral("b"));
        QCOMPARE(model.index(0, 2).data().toString(), QString());
    }

    void oldestGoWhenFull()
    {
        const SensorRegistry registry({}, StatusRules());
        MeasurementModel model(registry, 5, 3);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const char16_t line : u"abcde") {
            if (line != 0) {
                model.append(QString(line));
            }
        }
        QCOMPARE(firstFields(model), QStringLiteral("abcde"));
        model.append(QStringLiteral("f"));
        QCOMPARE(firstFields(model), QStringLiteral("def"));
    }

    void removesNoMoreThanThereAre()
    {
        const SensorRegistry registry({}, StatusRules());
        MeasurementModel model(registry, 2, 100);
        for (int i = 0; i < 5; ++i) {
            model.append(QString::number(i));
        }
        QCOMPARE(firstFields(model), QStringLiteral("4"));
    }
};

QTEST_MAIN(TestMeasurementModel)
#include "tst_measurementmodel.moc"
