#include "core/opc/opcfields.h"
#include "core/opc/opctags.h"
#include "tests/core/opc/opcsite.h"

#include <QSet>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;

namespace {

QStringList namesOf(const QList<OpcTag> &tags)
{
    QStringList names;
    for (const OpcTag &tag : tags) {
        names.append(tag.name);
    }
    return names;
}

QStringList below(const QString &branch, const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths) {
        names.append(branch + u'.' + path);
    }
    return names;
}

const QStringList state{u"STATE.Restart"_s, u"STATE.ReadyAngl"_s, u"STATE.ReadyTmp"_s, u"STATE.ReadErr"_s,
                        u"STATE.CRCErr"_s,  u"STATE.RangdErr"_s,  u"STATE.TReadErr"_s, u"STATE.TRangErr"_s};

QList<OpcTag> tagsOf(const QByteArray &port)
{
    return opcTags(opcSite("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=11\nN1=30\nOn1=1\n" + port).lines).sliced(32);
}

} // namespace

class TestOpcTags : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAreThoseOfTheFigure();
    void aliasesAreThoseOfTheTable();
    void typesAndDescriptions();
    void usmHasABranchByTheSameRule();
    void chainsAddDisplacements();
    void otherModelsOfTheFamily();
    void vibrationModule();
    void weatherStation();
    void weatherParametersByIni_data();
    void weatherParametersByIni();
    void weatherNamesFromOutside();
    void namesAreUnique();
    void withoutKeywordWithoutTags();
    void switchedOffIsListed();
    void hashIsThatOfTheText();
    void hashFollowsTheList();
    void listIsForPeople();
};

/// Figure 11.4, leaf by leaf; 7_Reserv and 8_Reserv of the ИН-Д3 by spec/opc.md.
void TestOpcTags::namesAreThoseOfTheFigure()
{
    const QStringList expected =
        below(
            u"[COM5].Sensor_001[AND3][Addr:002]"_s,
            state
                + QStringList{u"DATA.Angl_X"_s, u"DATA.Angl_Y"_s, u"DATA.AMax_X"_s, u"DATA.AMax_Y"_s, u"DATA.ARms_X"_s, u"DATA.ARms_Y"_s, u"DATA.Temper"_s, u"DATA.8_Reserv"_s})
        + below(
            u"[COM16].Sensor_002[IND3][Addr:003]"_s,
            state
                + QStringList{
                    u"DATA.Angl_X"_s, u"DATA.Angl_Y"_s, u"DATA.3_Reserv"_s, u"DATA.4_Reserv"_s, u"DATA.5_Reserv"_s,
                    u"DATA.6_Reserv"_s, u"DATA.7_Reserv"_s, u"DATA.8_Reserv"_s});
    QCOMPARE(namesOf(opcTags(opcSite().lines)), expected);
}

/// Table 11.1, column four, in its order; where it has a dash or nothing new there is no alias.
void TestOpcTags::aliasesAreThoseOfTheTable()
{
    const QStringList table{
        u"STATUS.Restart"_s,
        u"STATUS.ReadyAngl"_s,
        u"STATUS.ReadyTmpr"_s,
        u"STATUS.ReadErr"_s,
        u"STATUS.CRCErr"_s,
        u"STATUS.RangErr"_s,
        u"STATUS.TReadErr"_s,
        u"STATUS.TRangErr"_s,
        u""_s,
        u""_s,
        u"DATA.Amax_X"_s,
        u"DATA.Amax_Y"_s,
        u""_s,
        u"DATA.Arms_Y"_s,
        u"DATA.Rezerv"_s,
        u""_s};
    const QList<OpcTag> tags = opcTags(opcSite().lines);
    for (qsizetype i = 0; i < 16; ++i) {
        const QString alias = table.at(i);
        const QString branch = u"[COM5].Sensor_001[AND3][Addr:002]."_s;
        QCOMPARE(tags.at(i).aliases, alias.isEmpty() ? QStringList() : QStringList{branch + alias});
    }
    // the reserves of the ИН-Д3 have other names in the figure, so each has one of the table
    const QString branch = u"[COM16].Sensor_002[IND3][Addr:003]."_s;
    QCOMPARE(tags.at(16 + 2).aliases, QStringList{branch + u"STATUS.ReadyTmpr"_s});
    QCOMPARE(tags.at(16 + 8).aliases, QStringList());
    QCOMPARE(tags.at(16 + 10).aliases, QStringList{branch + u"DATA.Amax_X"_s});
    QCOMPARE(tags.at(16 + 12).aliases, QStringList{branch + u"DATA.ARms_X"_s});
    QCOMPARE(tags.at(16 + 14).aliases, QStringList{branch + u"DATA.Rezerv"_s});
}

void TestOpcTags::typesAndDescriptions()
{
    const QList<OpcTag> tags = opcTags(opcSite().lines);
    for (qsizetype i = 0; i < tags.size(); ++i) {
        QCOMPARE(tags.at(i).type, i % 16 < 8 ? OpcType::Bool : OpcType::Double);
        QCOMPARE(tags.at(i).number, i < 16 ? 1 : 2);
    }
    QCOMPARE(opcTypeName(OpcType::Bool), u"bool"_s);
    QCOMPARE(opcTypeName(OpcType::Double), u"double"_s);
    QCOMPARE(tags.at(0).description, u"АН-Д3 No. 1 (COM5, address 2): the restart was acknowledged"_s);
    QCOMPARE(tags.at(8).description, u"АН-Д3 No. 1 (COM5, address 2): angle X, arc-seconds"_s);
    QCOMPARE(tags.at(14).description, u"АН-Д3 No. 1 (COM5, address 2): temperature, °C"_s);
    QCOMPARE(tags.at(31).description, u"ИН-Д3 No. 2 (COM16, address 3): reserve"_s);
}

void TestOpcTags::usmHasABranchByTheSameRule()
{
    const QList<OpcTag> tags = tagsOf("Name1=УСМ-ИСН\n");
    QCOMPARE(
        namesOf(tags),
        below(
            u"[COM7].Sensor_030[USMISN][Addr:011]"_s,
            state
                + QStringList{u"DATA.Angl_X"_s, u"DATA.Angl_Y"_s, u"DATA.Var_X"_s, u"DATA.Var_Y"_s, u"DATA.Temper"_s}));
}

void TestOpcTags::chainsAddDisplacements()
{
    const QList<OpcTag> tags = tagsOf("Name1=УСМ-ИСН\n[Chain1]\nN1=30\nL1=3,6\n");
    QCOMPARE(
        namesOf(tags).sliced(13),
        below(u"[COM7].Sensor_030[USMISN][Addr:011]"_s, {u"DATA.Displ_X"_s, u"DATA.Displ_Y"_s}));
}

void TestOpcTags::otherModelsOfTheFamily()
{
    QCOMPARE(tagsOf("Name1=ИН-Д7\n").first().name, u"[COM7].Sensor_030[IND7][Addr:011].STATE.Restart"_s);
}

void TestOpcTags::vibrationModule()
{
    const QList<OpcTag> tags = tagsOf("Device=tcp://127.0.0.1:502\nName1=L-VIMS\n");
    const QStringList names = namesOf(tags);
    // four channels of 2 states, 8 × 4 flags and 8 × 3 values, eight relays of 3
    QCOMPARE(names.size(), 4 * (2 + 8 * 4 + 8 * 3) + 8 * 3);
    const QString branch = u"[COM7].Sensor_030[LVIMS][Addr:011]."_s;
    for (const char *path :
         {"STATE.Channel_0.ShortCircuit", "STATE.Channel_3.Break", "STATE.Channel_1.Meas_7.Fault",
          "STATE.Channel_2.Meas_0.Warning", "STATE.Channel_2.Meas_0.Stop", "STATE.Channel_0.Meas_3.Baseline",
          "STATE.Relay_0.Logical", "STATE.Relay_7.Physical", "STATE.Relay_4.Error"}) {
        const qsizetype at = names.indexOf(branch + QLatin1String(path));
        QVERIFY2(at >= 0, path);
        QCOMPARE(tags.at(at).type, OpcType::Bool);
    }
    for (const char *path :
         {"DATA.Channel_0.Meas_0.Type", "DATA.Channel_3.Meas_7.Value", "DATA.Channel_1.Meas_2.Percent"}) {
        const qsizetype at = names.indexOf(branch + QLatin1String(path));
        QVERIFY2(at >= 0, path);
        QCOMPARE(tags.at(at).type, OpcType::Double);
    }
}

void TestOpcTags::weatherStation()
{
    const QStringList names = namesOf(tagsOf("Name1=МК-14\n"));
    QCOMPARE(names.size(), 32 + 1 + 6 * 8);
    const QString branch = u"[COM7].Sensor_030[MK14][Addr:011]."_s;
    QCOMPARE(names.at(0), branch + u"STATE.Input_00"_s);
    QCOMPARE(names.at(31), branch + u"STATE.Input_31"_s);
    QCOMPARE(names.at(32), branch + u"STATE.Precipitation"_s);
    QCOMPARE(
        names.sliced(33, 8),
        below(
            branch.chopped(1),
            {u"DATA.U_1.Mean"_s, u"DATA.U_1.Instant"_s, u"DATA.U_1.Min"_s, u"DATA.U_1.Max"_s, u"DATA.U_1.Voltage"_s,
             u"DATA.U_1.VoltageInstant"_s, u"DATA.U_1.MaxPeriod"_s, u"DATA.U_1.Deviation"_s}));
    QStringList codes;
    for (qsizetype i = 33; i < names.size(); i += 8) {
        codes.append(names.at(i).section(u'.', -2, -2));
    }
    QCOMPARE(codes, (QStringList{u"U_1"_s, u"T_1"_s, u"P_1"_s, u"H_1"_s, u"A_1"_s, u"M_1"_s}));
}

void TestOpcTags::weatherParametersByIni_data()
{
    QTest::addColumn<QString>("list");
    QTest::addColumn<QString>("parameters");
    QTest::newRow("usual") << QString() << u"U1 T1 P1 H1 A1 M1"_s;
    QTest::newRow("own") << u"U,T,T,P"_s << u"U1 T1 T2 P1"_s;
    QTest::newRow("numbered") << u"T2, t1 T7;T"_s << u"T2 t1 T7 T8"_s;
    QTest::newRow("no list") << u"U,TT"_s << u"U1 T1 P1 H1 A1 M1"_s;
    QTest::newRow("nothing") << u" , "_s << u"U1 T1 P1 H1 A1 M1"_s;
}

void TestOpcTags::weatherParametersByIni()
{
    QFETCH(const QString, list);
    QFETCH(const QString, parameters);
    SensorConfig sensor;
    sensor.options.insert(u"params"_s, list);
    QStringList found;
    for (const WeatherParameter &parameter : weatherParameters(sensor)) {
        found.append(QString(parameter.code) + QString::number(parameter.number));
    }
    QCOMPARE(found.join(u' '), parameters);
}

void TestOpcTags::weatherNamesFromOutside()
{
    WeatherParameter parameter;
    parameter.code = u'T';
    parameter.number = 2;
    parameter.name = u"Air"_s;
    parameter.unit = u"°C"_s;
    const auto lines =
        opcSite("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=11\nN1=30\nOn1=1\nName1=МК-14\nParams1=U\n").lines;
    const QList<OpcTag> tags = opcTags(lines, {{30, {parameter, parameter}}}).sliced(32);
    QCOMPARE(tags.size(), 33 + 8);
    QCOMPARE(tags.at(33).name, u"[COM7].Sensor_030[MK14][Addr:011].DATA.T_2.Mean"_s);
    QCOMPARE(tags.at(33).description, u"МК-14 No. 30 (COM7, address 11): Air, mean, °C"_s);
    QCOMPARE(tags.at(37).description, u"МК-14 No. 30 (COM7, address 11): Air, primary value, mean, V or Hz"_s);
}

void TestOpcTags::namesAreUnique()
{
    const QList<OpcTag> tags = tagsOf("Name1=L-VIMS\nDevice=tcp://127.0.0.1:502\n")
        + tagsOf("Name1=МК-14\nParams1=T1,T1,T\n") + opcTags(opcSite().lines);
    QSet<QString> all;
    for (const OpcTag &tag : tags) {
        for (const QString &name : QStringList{tag.name} + tag.aliases) {
            QVERIFY2(!all.contains(name), qPrintable(name));
            all.insert(name);
        }
    }
}

void TestOpcTags::withoutKeywordWithoutTags()
{
    QCOMPARE(tagsOf("Name1=Reserve\n").size(), 0);
}

void TestOpcTags::switchedOffIsListed()
{
    QList<LineConfig> lines = opcSite().lines;
    const QByteArray hash = opcTagsHash(opcTags(lines));
    lines[0].isOn = false;
    lines[1].sensors[0].isOn = false;
    QCOMPARE(opcTagsHash(opcTags(lines)), hash);
}

/// By hand: printf 'name\ttype\n' of the 32 tags | sha256sum.
void TestOpcTags::hashIsThatOfTheText()
{
    QCOMPARE(opcTagsHash({}), QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    QCOMPARE(
        opcTagsHash(opcTags(opcSite().lines)),
        QByteArray("791381c8bcef9ac9b899c634ddf93530f0aa5d3deb13456082f364b42a010f9d"));
}

void TestOpcTags::hashFollowsTheList()
{
    const QByteArray hash = opcTagsHash(opcTags(opcSite().lines));
    QList<LineConfig> lines = opcSite().lines;
    lines[0].sensors[0].address = 4;
    QVERIFY(opcTagsHash(opcTags(lines)) != hash);
    lines[0].sensors[0].address = 2;
    lines[0].sensors[0].note = u"another note"_s;
    QCOMPARE(opcTagsHash(opcTags(lines)), hash);
    std::swap(lines[0], lines[1]);
    QVERIFY(opcTagsHash(opcTags(lines)) != hash);
    QList<OpcTag> tags = opcTags(opcSite().lines);
    tags[3].type = OpcType::Double;
    QVERIFY(opcTagsHash(tags) != hash);
}

void TestOpcTags::listIsForPeople()
{
    const QList<QByteArray> lines = opcTagList(opcTags(opcSite().lines)).split('\n');
    QCOMPARE(lines.size(), 33);
    QCOMPARE(
        QString::fromUtf8(lines.at(8)),
        u"[COM5].Sensor_001[AND3][Addr:002].DATA.Angl_X\tdouble\tАН-Д3 No. 1 (COM5, address 2): angle X, arc-seconds"_s);
    QCOMPARE(lines.last(), QByteArray());
}

QTEST_APPLESS_MAIN(TestOpcTags)
#include "tst_opctags.moc"
