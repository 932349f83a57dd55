#include "core/values/sensortype.h"

#include <QTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;

Q_DECLARE_METATYPE(SensorType)

/// Keywords in `Name{i}` (spec/gorizont.md, section 1).
class TestSensorType : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheModel_data();
    void findsTheModel();
    void findsTheOtherKeywords_data();
    void findsTheOtherKeywords();
    void writesModelsInRussian();
};

void TestSensorType::findsTheModel_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<SensorType>("type");
    QTest::addColumn<QString>("model");
    const auto row = [](const char *what, const QString &name, SensorType type, const QString &model) {
        QTest::newRow(what) << name << type << model;
    };
    row("manual, 5.3: letter З", u"АН1 (АН-ДЗ, TMP05)"_s, SensorType::AnD3, u"AN-D3"_s);
    row("manual, 5.3: ИН-ДЗ", u"ИН-ДЗ No1 (ИН-ДЗ, TMP05)"_s, SensorType::InD, u"IN-D3"_s);
    row("annex: АН Cyrillic, D Latin", u"АН-Д3_1 Этаж 2 Сектор А (АН-D3, TMP05, ускорение)"_s, SensorType::AnD3,
        u"AN-D3"_s);
    row("annex: Latin", u"Инклинометр ИН-Д3 (IN-D3)"_s, SensorType::InD, u"IN-D3"_s);
    row("all Latin", u"AN-D3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("all Cyrillic", u"АН-Д3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("Latin A, Cyrillic Н", u"AН-Д3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("Latin H for Н", u"AH-D3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("lower case", u"датчик ин-д9 в подвале"_s, SensorType::InD, u"IN-D9"_s);
    row("lower case letter з", u"ан-дз"_s, SensorType::AnD3, u"AN-D3"_s);
    row("ИН-Д2", u"ИН-Д2"_s, SensorType::InD, u"IN-D2"_s);
    row("ИН-Д7", u"IN-Д7"_s, SensorType::InD, u"IN-D7"_s);
    row("en dash", u"ИН–Д3"_s, SensorType::InD, u"IN-D3"_s);
    row("em dash", u"УСМ—ИСН"_s, SensorType::UsmIsn, u"USM-ISN"_s);
    row("non-breaking hyphen", u"АН‑Д3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("minus", u"МК−14"_s, SensorType::Mk14, u"MK-14"_s);
    row("УСМ-ИСН", u"УСМ-ИСН"_s, SensorType::UsmIsn, u"USM-ISN"_s);
    row("USM-ISN", u"usm-isn"_s, SensorType::UsmIsn, u"USM-ISN"_s);
    row("УСМ Cyrillic, ISN Latin", u"УСМ-ISN"_s, SensorType::UsmIsn, u"USM-ISN"_s);
    row("L-VIMS", u"Вибрация l-vims, ось"_s, SensorType::LVims, u"L-VIMS"_s);
    row("MK-14", u"MK-14"_s, SensorType::Mk14, u"MK-14"_s);
    row("inside a word", u"Новый_АН-Д3_1"_s, SensorType::AnD3, u"AN-D3"_s);

    row("parentheses win", u"ИН-Д3 рядом с (АН-Д3)"_s, SensorType::AnD3, u"AN-D3"_s);
    row("parentheses win from the front", u"(АН-Д3) рядом с ИН-Д3"_s, SensorType::AnD3, u"AN-D3"_s);
    row("else the first", u"ИН-Д9 вместо АН-Д3"_s, SensorType::InD, u"IN-D9"_s);
    row("the first in parentheses", u"УСМ-ИСН (МК-14, АН-Д3)"_s, SensorType::Mk14, u"MK-14"_s);
    row("after closed parentheses", u"(этаж 2) ИН-Д3 АН-Д3"_s, SensorType::InD, u"IN-D3"_s);
    row("parenthesis not closed", u"ИН-Д3 (АН-Д3"_s, SensorType::AnD3, u"AN-D3"_s);

    row("IN-D34", u"IN-D34"_s, SensorType::None, QString());
    row("IN-D34, then IN-D3", u"IN-D34 (IN-D3)"_s, SensorType::InD, u"IN-D3"_s);
    row("MK-140", u"МК-140"_s, SensorType::None, QString());
    row("ИН-Д4", u"ИН-Д4"_s, SensorType::None, QString());
    row("АН-Д9", u"АН-Д9"_s, SensorType::None, QString());
    row("no dash", u"АНД3"_s, SensorType::None, QString());
    row("empty", QString(), SensorType::None, QString());
}

void TestSensorType::findsTheModel()
{
    QFETCH(QString, name);
    QFETCH(SensorType, type);
    QFETCH(QString, model);
    const NameKeywords keywords = readKeywords(name);
    QCOMPARE(keywords.type, type);
    QCOMPARE(keywords.model, model);
}

void TestSensorType::findsTheOtherKeywords_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("hasThermometer");
    QTest::addColumn<bool>("hasAcceleration");
    QTest::addColumn<bool>("hasThermostat");
    QTest::newRow("annex") << u"АН-Д3_2 Этаж 2 Сектор Б (АН-D3, TMP05, ускорение)"_s << true << true << false;
    QTest::newRow("none") << u"Инклинометр ИН-Д3 (IN-D3)"_s << false << false << false;
    QTest::newRow("Cyrillic ТМР05") << u"АН-Д3 ТМР05"_s << true << false << false;
    QTest::newRow("capitals") << u"УСКОРЕНИЕ, ПОДОГРЕВ, tmp05"_s << true << true << true;
    QTest::newRow("heating") << u"АН-Д3 (подогрев)"_s << false << false << true;
}

void TestSensorType::findsTheOtherKeywords()
{
    QFETCH(QString, name);
    QFETCH(bool, hasThermometer);
    QFETCH(bool, hasAcceleration);
    QFETCH(bool, hasThermostat);
    const NameKeywords keywords = readKeywords(name);
    QCOMPARE(keywords.hasThermometer, hasThermometer);
    QCOMPARE(keywords.hasAcceleration, hasAcceleration);
    QCOMPARE(keywords.hasThermostat, hasThermostat);
}

void TestSensorType::writesModelsInRussian()
{
    QCOMPARE(modelInRussian(u"IN-D3"_s), u"ИН-Д3"_s);
    QCOMPARE(modelInRussian(u"AN-D3"_s), u"АН-Д3"_s);
    QCOMPARE(modelInRussian(u"USM-ISN"_s), u"УСМ-ИСН"_s);
    QCOMPARE(modelInRussian(u"MK-14"_s), u"МК-14"_s);
    QCOMPARE(modelInRussian(u"L-VIMS"_s), u"L-VIMS"_s);
    QCOMPARE(modelInRussian(u"unknown"_s), u"unknown"_s);
}

QTEST_GUILESS_MAIN(TestSensorType)

#include "tst_sensortype.moc"
