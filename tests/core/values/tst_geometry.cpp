#include "core/values/geometry.h"

#include <QTest>

using namespace gorizont;

/// spec/gorizont.md, section 2: Y := −Y if InvY; X′ = X·cos α + Y·sin α − Xo; Y′ = −X·sin α + Y·cos α − Yo.
class TestGeometry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void correctsTilt_data();
    void correctsTilt();
    void turnsAccelerationsWithoutOffsets();
};

void TestGeometry::correctsTilt_data()
{
    QTest::addColumn<double>("rotation");
    QTest::addColumn<bool>("isInverted");
    QTest::addColumn<double>("offsetX");
    QTest::addColumn<double>("offsetY");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");

    // Always from (100, 20).
    QTest::newRow("nothing") << 0.0 << false << 0.0 << 0.0 << 100.0 << 20.0;
    QTest::newRow("offsets") << 0.0 << false << 7.0 << -3.0 << 93.0 << 23.0;
    QTest::newRow("inverted") << 0.0 << true << 0.0 << 0.0 << 100.0 << -20.0;
    QTest::newRow("90°") << 90.0 << false << 0.0 << 0.0 << 20.0 << -100.0;
    QTest::newRow("180°") << 180.0 << false << 0.0 << 0.0 << -100.0 << -20.0;
    QTest::newRow("-90°") << -90.0 << false << 0.0 << 0.0 << -20.0 << 100.0;
    QTest::newRow("inverted before turned") << 90.0 << true << 0.0 << 0.0 << -20.0 << -100.0;
    QTest::newRow("offsets after turned") << 90.0 << false << 7.0 << -3.0 << 13.0 << -97.0;
    QTest::newRow("all of it") << 90.0 << true << 7.0 << -3.0 << -27.0 << -97.0;
    QTest::newRow("30°") << 30.0 << false << 0.0 << 0.0 << 96.60254037844386 << -32.67949192431123;
}

void TestGeometry::correctsTilt()
{
    QFETCH(double, rotation);
    QFETCH(bool, isInverted);
    QFETCH(double, offsetX);
    QFETCH(double, offsetY);
    QFETCH(double, x);
    QFETCH(double, y);
    SensorConfig sensor;
    sensor.rotationX = rotation;
    sensor.isYInverted = isInverted;
    sensor.offsetX = offsetX;
    sensor.offsetY = offsetY;
    const Tilt corrected = correctedTilt({100, 20}, AxisTransform(sensor), sensor);
    QVERIFY2(qAbs(corrected.x - x) < 1e-9, qPrintable(QString::number(corrected.x)));
    QVERIFY2(qAbs(corrected.y - y) < 1e-9, qPrintable(QString::number(corrected.y)));
}

void TestGeometry::turnsAccelerationsWithoutOffsets()
{
    SensorConfig sensor;
    sensor.rotationX = 90;
    sensor.offsetX = 1000;
    sensor.offsetY = 1000;
    const Tilt turned = AxisTransform(sensor)(3, -4);
    QVERIFY(qAbs(turned.x + 4) < 1e-9);
    QVERIFY(qAbs(turned.y + 3) < 1e-9);
}

QTEST_GUILESS_MAIN(TestGeometry)

#include "tst_geometry.moc"
