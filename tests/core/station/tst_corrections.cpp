#include "core/station/correctionfile.h"
#include "core/station/parameterjudge.h"

#include <QTest>

using namespace gorizont::station;

namespace {

Corrections read(CorrectionKind kind, const char *text)
{
    Complaints complaints;
    Corrections corrections;
    readCorrection(kind, QStringLiteral("X.P01"), QByteArray(text), corrections, complaints);
    const QList<StationComplaint> list = complaints.list();
    for (const StationComplaint &complaint : list) {
        qWarning("%s", qUtf8Printable(complaint.text()));
    }
    return corrections;
}

const char *const twoRows = "-20.0  0.5  0.016\n20.0  -0.1 -0.02\n";
const char *const coefficientRows = "c0      -1.011052 -0.0130706 0.00318116\n"
                                    "c1      0.078984 -0.0094569 0.000275385\n";

ParameterConfig straight()
{
    ParameterConfig config;
    config.code = u'P';
    config.conversion.coefficients = {0, 1};
    return config;
}

} // namespace

/// The examples of manual 004, section 3.2, at and beyond the edges of their rows. Expected numbers by Python.
class TestCorrections : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void byTemperature_data()
    {
        QTest::addColumn<double>("t");
        QTest::addColumn<double>("correction");
        QTest::newRow("far below") << -30.0 << 0.02;
        QTest::newRow("just below the first") << -20.0001 << 0.1799984;
        QTest::newRow("at the first") << -20.0 << 0.3;
        QTest::newRow("between") << 0.0 << -0.1;
        QTest::newRow("just below the second") << 19.9999 << -0.499998;
        QTest::newRow("at the second") << 20.0 << 0.0;
        QTest::newRow("beyond") << 45.0 << 0.0;
    }

    /// "INPUT.P01" and "METEO.P01" hold the same two lines; the first adds to the voltage, the second to the pressure.
    void byTemperature()
    {
        QFETCH(const double, t);
        QFETCH(const double, correction);
        const Corrections input = read(CorrectionKind::Input, twoRows);
        QVERIFY(!input.inputThermometer);
        QVERIFY(qAbs(inputCorrection(input, t) - correction) < 1e-12);
        QCOMPARE(physicalCorrection(input, t, 3.0), 0.0);
        const Corrections meteo = read(CorrectionKind::Meteo, twoRows);
        QVERIFY(qAbs(physicalCorrection(meteo, t, 3.0) - correction) < 1e-12);
        QCOMPARE(inputCorrection(meteo, t), 0.0);
    }

    void inputNamesItsThermometer()
    {
        const Corrections input = read(CorrectionKind::Input, "~f01\n-20.0  0.5  0.016\n20.0  -0.1 -0.02\n");
        QCOMPARE(input.inputThermometer, (ParameterId{u'f', 1}));
        QCOMPARE(input.input.rows.size(), 2);
        QVERIFY(!input.isFaulty);
        QVERIFY(qAbs(inputCorrection(input, -30) - 0.02) < 1e-12);
    }

    void byValue_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("correction");
        QTest::newRow("row without coefficients") << 1.0 << 0.0;
        QTest::newRow("just below the first") << 2.5499999 << 0.0;
        QTest::newRow("at the first") << 2.55 << 0.009949;
        QTest::newRow("between") << 3.0 << 0.00994;
        QTest::newRow("just below the second") << 3.1599 << 0.009936802;
        QTest::newRow("at the second") << 3.16 << 0.0;
        QTest::newRow("beyond") << 9.0 << 0.0;
    }

    void byValue()
    {
        QFETCH(const double, x);
        QFETCH(const double, correction);
        const Corrections correct = read(CorrectionKind::Correct, "2.55\n3.16  0.01  -0.00002\n");
        QVERIFY(qAbs(physicalCorrection(correct, {}, x) - correction) < 1e-12);
        QVERIFY(qAbs(physicalCorrection(correct, 15.0, x) - correction) < 1e-12);
    }

    void byBoth_data()
    {
        QTest::addColumn<double>("t");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("correction");
        QTest::newRow("below the first") << -25.0 << 4.0 << 0.564;
        QTest::newRow("at the first") << -20.0 << 4.0 << -0.18;
        QTest::newRow("at the second") << 20.0 << 4.0 << 0.0;
    }

    /// The first form of REAL: t chooses the row, x goes into its polynomial.
    void byBoth()
    {
        QFETCH(const double, t);
        QFETCH(const double, x);
        QFETCH(const double, correction);
        QVERIFY(qAbs(physicalCorrection(read(CorrectionKind::Real, twoRows), t, x) - correction) < 1e-12);
    }

    void byCoefficients_data()
    {
        QTest::addColumn<double>("t");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("correction");
        QTest::newRow("t 0, x 0") << 0.0 << 0.0 << -1.011052;
        QTest::newRow("t 0, x 5") << 0.0 << 5.0 << -0.616132;
        QTest::newRow("t 10, x 4.2") << 10.0 << 4.2 << -0.7734373;
        QTest::newRow("t -25, x 2.5") << -25.0 << 2.5 << 2.5227433125;
    }

    /// The second form of REAL.
    void byCoefficients()
    {
        QFETCH(const double, t);
        QFETCH(const double, x);
        QFETCH(const double, correction);
        const Corrections real = read(CorrectionKind::Real, coefficientRows);
        QCOMPARE(real.real.byTemperature.size(), 2);
        QVERIFY(qAbs(physicalCorrection(real, t, x) - correction) < 1e-12);
    }

    void rowsOfCoefficientsInAnyOrder()
    {
        const Corrections real = read(CorrectionKind::Real, "С2 1\nc0 3 1\n");
        QCOMPARE(physicalCorrection(real, 2.0, 10.0), 105.0);
    }

    void withoutATemperatureOnlyTheValueCounts()
    {
        Corrections all = read(CorrectionKind::Correct, "2.55\n3.16  0.01  -0.00002\n");
        all.meteo = read(CorrectionKind::Meteo, twoRows).meteo;
        all.input = all.meteo;
        all.real = read(CorrectionKind::Real, twoRows).real;
        QVERIFY(qAbs(physicalCorrection(all, {}, 3.0) - 0.00994) < 1e-12);
        QCOMPARE(inputCorrection(all, {}), 0.0);
    }

    void faulty_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("complaint");
        const auto row = [](const char *name, CorrectionKind kind, const char *text, const char *complaint) {
            QTest::newRow(name) << static_cast<int>(kind) << QByteArray(text)
                                << QString::fromUtf8(complaint) + QStringLiteral(" The parameter gets no values.");
        };
        using enum CorrectionKind;
        row("key", Meteo, "cold 1", "X.P01, line 1, field 1 (temperature): “cold” is not a number.");
        row("key of a value", Correct, "1 2\nx", "X.P01, line 2, field 1 (measured value): “x” is not a number.");
        row("coefficient", Meteo, "\n5 1 2 a", "X.P01, line 2, field 4 (polynomial): “a” is not a number.");
        row("eleven coefficients", Meteo, "5 0 1 2 3 4 5 6 7 8 9 10",
            "X.P01, line 1, field 12 (polynomial): A polynomial has at most 10 coefficients.");
        row("falling keys", Input, "5 1\n5 2",
            "X.P01, line 2, field 1 (temperature): The value is not greater than the one in the line before.");
        row("thermometer in METEO", Meteo, "~f01",
            "X.P01, line 1, field 1 (thermometer): Only a file INPUT names its thermometer.");
        row("thermometer in line 2", Input, "5 1\n~f01",
            "X.P01, line 2, field 1 (thermometer): The thermometer is named in the first line only.");
        row("no thermometer", Input, "~1",
            "X.P01, line 1, field 1 (thermometer): “~1” is not a code and a number, as in ~f01.");
        row("letter", Real, "d0 1", "X.P01, line 1, field 1 (coefficient): “d0” is not one of c0 … c9.");
        row("mixed", Real, "c0 1\n5 1",
            "X.P01, line 2, field 1 (temperature): Lines with a temperature and lines with c0, c1, … cannot stand in "
            "one file.");
        row("mixed the other way", Real, "5 1\nc0 1",
            "X.P01, line 2, field 1 (coefficient): Lines with a temperature and lines with c0, c1, … cannot stand in "
            "one file.");
        row("twice", Real, "c1 1\nc1 2", "X.P01, line 2, field 1 (coefficient): c1 stands in the file twice.");
        row("empty coefficient", Real, "c0",
            "X.P01, line 1, field 2 (polynomial): The polynomial has no coefficients.");
    }

    void faulty()
    {
        QFETCH(const int, kind);
        QFETCH(const QByteArray, text);
        QFETCH(const QString, complaint);
        Complaints complaints;
        Corrections corrections;
        readCorrection(static_cast<CorrectionKind>(kind), QStringLiteral("X.P01"), text, corrections, complaints);
        QCOMPARE(complaints.list().size(), 1);
        QCOMPARE(complaints.list().first().text(), complaint);
        QVERIFY(corrections.isFaulty);
    }

    /// Every correction is seen apart because each one has its own power of ten: raw 2, t 1, and the polynomial doubles what it
    /// gets. INPUT goes through the polynomial; CORRECT and REAL get the value before INPUT.
    void orderOfCorrections()
    {
        Corrections all;
        all.input = read(CorrectionKind::Input, "9 0.1").input; // 2 + 0.1
        all.meteo = read(CorrectionKind::Meteo, "9 0 100").meteo; // 100·t
        all.correct = read(CorrectionKind::Correct, "2.05 0 1000\n9 0 7777").correct; // 1000·raw while raw < 2.05
        all.real = read(CorrectionKind::Real, "c1 10000").real; // 10000·raw
        ParameterConfig config = straight();
        config.conversion.coefficients = {0, 2};
        const ParameterJudge judge(config, all);
        QCOMPARE(judge.judge(2.0, {1.0, 1.0}, {}).physical, 2 * 2.1 + 100 + 2000 + 20000);
        QCOMPARE(judge.judge(2.0, {{}, 1.0}, {}).physical, 2 * 2.0 + 100 + 2000 + 20000);
        QCOMPARE(judge.judge(2.0, {}, {}).physical, 2 * 2.0 + 2000);
    }

    void polynomialWithOrigin()
    {
        ParameterConfig config = straight();
        config.conversion = {2.0, {1, 10, 100}};
        QCOMPARE(ParameterJudge(config, {}).judge(5.0, {}, {}).physical, 1 + 10 * 3 + 100 * 9.0);
    }

    void threshold_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("below") << 1.0 << 10.0;
        QTest::newRow("at c0 - error") << 2.25 << 10.0;
        QTest::newRow("above it") << 2.26 << 20.0;
        QTest::newRow("at c0") << 2.5 << 20.0;
        QTest::newRow("below c0 + error") << 2.74 << 20.0;
        QTest::newRow("at c0 + error") << 2.75 << 30.0;
        QTest::newRow("above") << 4.0 << 30.0;
    }

    /// c0 2.5, error 0.25, left 10, right 30. The error is no gate there, whatever the mean.
    void threshold()
    {
        QFETCH(const double, x);
        ParameterConfig config = straight();
        config.conversion = {0, {2.5}};
        config.limits = {10, 30};
        config.error = 0.25;
        const Judged judged = ParameterJudge(config, {}).judge(x, {}, 20.0);
        QTEST(judged.physical.value_or(0), "y");
        QVERIFY(judged.isGood());
    }

    void limitsAndGate()
    {
        ParameterConfig config = straight();
        config.limits = {-1, 5};
        config.error = 0.5;
        const ParameterJudge judge(config, {});
        QCOMPARE(judge.judge({}, {}, {}).verdict, Verdict::Missing);
        QCOMPARE(judge.judge(qQNaN(), {}, {}).verdict, Verdict::Missing);
        QCOMPARE(judge.judge(-1.0, {}, {}).verdict, Verdict::Good);
        QCOMPARE(judge.judge(-1.01, {}, {}).verdict, Verdict::OutsideLimits);
        QCOMPARE(judge.judge(5.0, {}, {}).verdict, Verdict::Good);
        QCOMPARE(judge.judge(5.01, {}, {}).verdict, Verdict::OutsideLimits);
        QCOMPARE(judge.judge(5.01, {}, {}).physical, 5.01);
        QCOMPARE(judge.judge(2.5, {}, 2.0).verdict, Verdict::Good);
        QCOMPARE(judge.judge(2.51, {}, 2.0).verdict, Verdict::FarFromMean);
        QCOMPARE(judge.judge(2.51, {}, {}).verdict, Verdict::Good);
    }

    /// The error of M is something else, and that of A goes around the circle.
    void gateOfWind()
    {
        ParameterConfig config = straight();
        config.error = 20;
        config.code = u'M';
        QCOMPARE(ParameterJudge(config, {}).judge(50.0, {}, 0.0).verdict, Verdict::Good);
        config.code = u'A';
        QCOMPARE(ParameterJudge(config, {}).judge(350.0, {}, 5.0).verdict, Verdict::Good);
        QCOMPARE(ParameterJudge(config, {}).judge(340.0, {}, 5.0).verdict, Verdict::FarFromMean);
    }

    void testMode()
    {
        ParameterConfig config = straight();
        config.conversion.coefficients = {5, 7};
        config.limits = {0, 1};
        config.error = 0;
        ParameterJudge judge(config, read(CorrectionKind::Correct, "9 1"));
        judge.beginTest();
        QCOMPARE(judge.judge(2.0, {1.0, 1.0}, 0.0), (Judged{2.0, Verdict::Good}));
    }

    void gamma()
    {
        ParameterConfig config = straight();
        config.limits = {0, 10};
        config.error = 0.1;
        ParameterJudge judge(config, read(CorrectionKind::Correct, "999 1"));
        GammaConfig gamma;
        gamma.sensitivity = 4;
        gamma.background = 2;
        judge.measureGamma(gamma);
        QCOMPARE(judge.judge(22.0, {}, 0.0), (Judged{5.0, Verdict::Good}));
        QCOMPARE(judge.judge(1.0, {}, {}).verdict, Verdict::OutsideLimits);
    }
};

QTEST_GUILESS_MAIN(TestCorrections)
#include "tst_corrections.moc"
