#include "core/station/wind.h"

#include <QRandomGenerator>
#include <QTest>

using namespace gorizont::station;

/// Wind by components (manual 004, section 5.3).
class TestStationWind : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turns()
    {
        QCOMPARE(turned(-10), 350.0);
        QCOMPARE(turned(360), 0.0);
        QCOMPARE(turned(725), 5.0);
        QCOMPARE(turned(-1e-20), 0.0);
        QCOMPARE(angleBetween(350, 10), 20.0);
        QCOMPARE(angleBetween(10, 350), 20.0);
        QCOMPARE(angleBetween(0, 180), 180.0);
    }

    /// Numbers by Python: the mean of 350, 10, 20 and Yamartino's σ.
    void aroundNorth()
    {
        DirectionWindow window(3);
        QVERIFY(!window.mean());
        QVERIFY(!window.deviation());
        for (const double direction : {90.0, 350.0, 10.0, 20.0}) {
            window.push(direction);
        }
        QVERIFY(qAbs(*window.mean() - 6.70495327058324) < 1e-9);
        QVERIFY(qAbs(*window.deviation() - 12.479130663656095) < 1e-9);
    }

    void deviationAtTheEdges()
    {
        DirectionWindow window(2);
        window.push(123);
        QVERIFY(*window.deviation() < 1e-5);
        QVERIFY(qAbs(*window.mean() - 123) < 1e-9);
        window.push(213);
        QVERIFY(qAbs(*window.deviation() - 47.46127049417653) < 1e-9);
        window.push(33);
        QVERIFY(!window.mean());
        QVERIFY(qAbs(*window.deviation() - 103.92304845413265) < 1e-9);
    }

    /// The same wind, seen from a mast that was turned.
    void rotation_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {1.0, 90.0, 180.0, 271.5, -45.0}) {
            QTest::addRow("%g", angle) << angle;
        }
    }

    void rotation()
    {
        QFETCH(const double, angle);
        QRandomGenerator random(7);
        DirectionWindow plain(600);
        DirectionWindow rotated(600);
        VectorWindow plainVector(600);
        VectorWindow rotatedVector(600);
        for (int i = 0; i < 1500; ++i) {
            const double direction = 300 + random.bounded(100.0);
            const double speed = random.bounded(12.0);
            plain.push(direction);
            rotated.push(direction + angle);
            plainVector.push(speed, direction);
            rotatedVector.push(speed, direction + angle);
        }
        QVERIFY(angleBetween(*rotated.mean(), *plain.mean() + angle) < 1e-9);
        QVERIFY(qAbs(*rotated.deviation() - *plain.deviation()) < 1e-9);
        QVERIFY(qAbs(*rotatedVector.modulus() - *plainVector.modulus()) < 1e-9);
    }

    void vectors()
    {
        VectorWindow window(2);
        QVERIFY(!window.modulus());
        window.push(3, 0);
        window.push(4, 90);
        QVERIFY(qAbs(*window.modulus() - 2.5) < 1e-12);
        window.push({}, 90);
        QVERIFY(qAbs(*window.modulus() - 4) < 1e-12);
        window.push(5, {});
        QVERIFY(!window.modulus());
    }
};

QTEST_GUILESS_MAIN(TestStationWind)
#include "tst_stationwind.moc"
