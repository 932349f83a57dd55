#include "core/values/captureformat.h"
#include "core/values/captureplan.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

CapturePlan planOf(const QHash<QString, QString> &options)
{
    SensorConfig sensor;
    sensor.index = 3;
    sensor.options = options;
    return CapturePlan::from(sensor);
}

} // namespace

class TestCapturePlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offUnlessAskedFor()
    {
        const CapturePlan plan = planOf({{u"capturechannels"_s, u"1"_s}});
        QVERIFY(!plan.isOn());
        QCOMPARE(plan.complaints, QStringList());
    }

    void whatIsUsual()
    {
        const CapturePlan plan = planOf({{u"captureevery"_s, u"60"_s}});
        QVERIFY(plan.isOn());
        QVERIFY(plan.every == 60s);
        QCOMPARE(plan.channels, (QList<int>{0, 1, 2, 3}));
        QCOMPARE(plan.kinds, QList<CaptureKind>{CaptureKind::Waveform});
        QVERIFY(plan.savesCsv && !plan.savesWav);
        QVERIFY(plan.keep == std::chrono::days(0));
    }

    void allThatCanBeSaid()
    {
        const CapturePlan plan = planOf(
            {{u"captureevery"_s, u" 5 "_s},
             {u"capturechannels"_s, u"2, 0,2"_s},
             {u"capturekinds"_s, u"200, Waveform"_s},
             {u"captureformat"_s, u"WAV"_s},
             {u"capturekeep"_s, u"30"_s}});
        QCOMPARE(plan.complaints, QStringList());
        QVERIFY(plan.every == 5s);
        QCOMPARE(plan.channels, (QList<int>{2, 0}));
        QCOMPARE(plan.kinds, (QList<CaptureKind>{CaptureKind::Spectrum200, CaptureKind::Waveform}));
        QVERIFY(!plan.savesCsv && plan.savesWav);
        QVERIFY(plan.keep == std::chrono::days(30));
    }

    void whatIsNotUnderstood()
    {
        const CapturePlan plan = planOf(
            {{u"captureevery"_s, u"86401"_s},
             {u"capturechannels"_s, u"1,4"_s},
             {u"capturekinds"_s, u"3000"_s},
             {u"captureformat"_s, u"mp3"_s},
             {u"capturekeep"_s, u"-1"_s}});
        QCOMPARE(
            plan.complaints,
            (QStringList{
                u"CaptureEvery3: \"86401\" is not understood; it takes 0…86400. Its usual value is used."_s,
                u"CaptureKeep3: \"-1\" is not understood; it takes 0…36500. Its usual value is used."_s,
                u"CaptureChannels3: \"4\" is not understood; it takes 0, 1, 2, 3. Its usual value is used."_s,
                u"CaptureKinds3: \"3000\" is not understood; it takes waveform, 5000, 200. Its usual value is used."_s,
                u"CaptureFormat3: \"mp3\" is not understood; it takes csv, wav. Its usual value is used."_s}));
        QVERIFY(!plan.isOn());
        QCOMPARE(plan.channels.size(), 4);
    }
};

QTEST_APPLESS_MAIN(TestCapturePlan)
#include "tst_captureplan.moc"
