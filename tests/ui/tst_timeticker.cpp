#include "ui/plots/timeticker.h"

#include <QtTest>

using namespace gorizont;

/// What stands below a time axis is the time of its tick, whatever is seen.
class TestTimeTicker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void labelsAreTrue_data()
    {
        QTest::addColumn<double>("span");
        for (const double span :
             {1.0, 7.0, 60.0, 300.0, 599.0, 600.0, 750.0, 1800.0, 3600.0, 7200.0, 30000.0, 86400.0, 3 * 86400.0,
              4 * 86400.0, 7 * 86400.0, 31 * 86400.0, 149 * 86400.0}) {
            QTest::newRow(qPrintable(QString::number(span))) << span;
        }
    }
    void labelsAreTrue()
    {
        QFETCH(double, span);
        const double begin = 1517999583.25; // 2018-02-07 10:33:03.250 UTC
        TimeTicker ticker;
        QVector<double> ticks;
        QVector<QString> labels;
        ticker.generate({begin, begin + span}, QLocale::c(), QChar(u'f'), 6, ticks, nullptr, &labels);
        QVERIFY(ticks.size() >= 2);
        QCOMPARE(labels.size(), ticks.size());
        for (qsizetype i = 0; i < ticks.size(); ++i) {
            const QString &label = labels.at(i);
            QCOMPARE(read(label), ticks.at(i));
            QVERIFY(label != labels.value(i + 1));
        }
    }

private:
    /// Seconds since 1970; a label leaves out what it calls zero.
    static double read(const QString &label)
    {
        for (const char *format :
             {"hh:mm:ss.zzz\ndd.MM.yyyy", "hh:mm:ss\ndd.MM.yyyy", "hh:mm\ndd.MM.yyyy", "dd.MM\nyyyy"}) {
            QString whole = label;
            if (label.contains(u':')) {
                whole.insert(whole.lastIndexOf(u'.') + 1, QStringLiteral("20"));
            }
            const QDateTime time = QDateTime::fromString(whole, QLatin1String(format));
            if (time.isValid()) {
                return static_cast<double>(time.toMSecsSinceEpoch()) / 1000;
            }
        }
        return qQNaN();
    }
};

QTEST_APPLESS_MAIN(TestTimeTicker)
#include "tst_timeticker.moc"
