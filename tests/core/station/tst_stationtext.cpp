#include "core/station/stationconfig.h"
#include "core/station/stationtext.h"

#include <QTest>

using namespace gorizont::station;

/// Lines, fields, letters and the four encodings of the files.
class TestStationText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The bytes are those of Python's codecs.
    void encodings_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("text");

        const QString temperature = QStringLiteral("Температура °C");
        QTest::newRow("ASCII") << QByteArray("P 1 0.5") << QStringLiteral("P 1 0.5");
        QTest::newRow("nothing") << QByteArray() << QString();
        QTest::newRow("UTF-8") << QByteArray(
            "\xd0\xa2\xd0\xb5\xd0\xbc\xd0\xbf\xd0\xb5\xd1\x80\xd0\xb0\xd1\x82\xd1\x83\xd1\x80\xd0\xb0 \xc2\xb0"
            "C") << temperature;
        QTest::newRow("UTF-8 with BOM") << QByteArray("\xef\xbb\xbf\xd0\xa2") << QStringLiteral("Т");
        QTest::newRow("CP866") << QByteArray("\x92\xa5\xac\xaf\xa5\xe0\xa0\xe2\xe3\xe0\xa0 \xf8"
                                             "C")
                               << temperature;
        QTest::newRow("Windows-1251") << QByteArray("\xd2\xe5\xec\xef\xe5\xf0\xe0\xf2\xf3\xf0\xe0 \xb0"
                                                    "C")
                                      << temperature;
        QTest::newRow("CP866, only a degree sign") << QByteArray("T \xf8"
                                                                 "C")
                                                   << QStringLiteral("T °C");
        QTest::newRow("Windows-1251, ш at the start") << QByteArray("\xf8\xf3\xec") << QStringLiteral("шум");
        QTest::newRow("CP866, capitals") << QByteArray("\x84\x80\x82\x8b\x85\x8d\x88\x85")
                                         << QStringLiteral("ДАВЛЕНИЕ");
        QTest::newRow("Windows-1251, capitals")
            << QByteArray("\xc4\xc0\xc2\xcb\xc5\xcd\xc8\xc5") << QStringLiteral("ДАВЛЕНИЕ");
        QTest::newRow("letters that both share: Windows-1251") << QByteArray("\xe5\xe5") << QStringLiteral("ее");
        QTest::newRow("end of a DOS file") << QByteArray("P 1\r\n\x1a rubbish") << QStringLiteral("P 1\r\n");
    }

    void encodings()
    {
        QFETCH(const QByteArray, bytes);
        QTEST(decodeStationText(bytes), "text");
    }

    /// The upper half of CP866 as Python decodes it.
    void everyByteOfCp866()
    {
        QByteArray bytes("\x80\x80\x80\x80"); // four letters so that it is taken for CP866
        QString expected = QStringLiteral("АААА");
        const QString table = QStringLiteral(
            "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмноп░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀"
            "рстуфхцчшщъыьэюяЁёЄєЇїЎў°∙·√№¤■\u00A0");
        QCOMPARE(table.size(), 128);
        for (int code = 0x80; code < 0x100; ++code) {
            bytes.append(static_cast<char>(code));
        }
        bytes.append(QByteArray(100, '\x80'));
        QCOMPARE(decodeStationText(bytes), expected + table + QString(100, u'А'));
    }

    void fields()
    {
        const QList<Record> records = recordsOf(
            QStringLiteral("; comment\r\n\r\n\"Скорость ветра\" м/с\t- M;end\r  7 \"a;b\"\n\"open ; to the end\n"));
        QCOMPARE(records.size(), 3);
        QCOMPARE(records[0].line, 3);
        const QList<Field> expected{
            {QStringLiteral("Скорость ветра"), true},
            {QStringLiteral("м/с"), false},
            {QStringLiteral("-"), false},
            {QStringLiteral("M"), false}};
        QCOMPARE(records[0].fields, expected);
        QVERIFY(records[0].fields[2].isNone());
        QVERIFY(!records[0].fields[3].isNone());
        QCOMPARE(records[1].line, 4);
        QCOMPARE(records[1].fields[1].text, QStringLiteral("a;b"));
        QVERIFY(!records[1].isQuoteOpen);
        QCOMPARE(records[2].line, 5);
        QVERIFY(records[2].isQuoteOpen);
        QCOMPARE(records[2].fields[0].text, QStringLiteral("open ; to the end"));
    }

    void aQuotedDashIsADash() { QVERIFY(!recordsOf(QStringLiteral("\"-\""))[0].fields[0].isNone()); }

    void numbers_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isNumber");
        QTest::addColumn<double>("value");
        QTest::newRow("point") << QStringLiteral("-0.016") << true << -0.016;
        QTest::newRow("comma") << QStringLiteral("0,5") << true << 0.5;
        QTest::newRow("exponent") << QStringLiteral("1e-3") << true << 0.001;
        QTest::newRow("word") << QStringLiteral("abc") << false << 0.0;
        QTest::newRow("tail") << QStringLiteral("1.5x") << false << 0.0;
        QTest::newRow("nan") << QStringLiteral("nan") << false << 0.0;
        QTest::newRow("infinite") << QStringLiteral("inf") << false << 0.0;
        QTest::newRow("too great") << QStringLiteral("1e999") << false << 0.0;
        QTest::newRow("empty") << QString() << false << 0.0;
    }

    void numbers()
    {
        QFETCH(const QString, text);
        QFETCH(const bool, isNumber);
        const auto number = numberOf(text);
        QCOMPARE(number.has_value(), isNumber);
        QTEST(number.value_or(0), "value");
    }

    void names_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("canonical");
        QTest::newRow("Latin") << QStringLiteral("ACK.INI") << QStringLiteral("ACK.INI");
        QTest::newRow("Cyrillic") << QStringLiteral("АСК.INI") << QStringLiteral("ACK.INI");
        QTest::newRow("Cyrillic, small") << QStringLiteral("аск.par") << QStringLiteral("ACK.PAR");
        QTest::newRow("mixed") << QStringLiteral("AСk.РАR") << QStringLiteral("ACK.PAR");
        QTest::newRow("correction") << QStringLiteral("input.p01") << QStringLiteral("INPUT.P01");
        QTest::newRow("correction, Cyrillic letter") << QStringLiteral("Real.Р12") << QStringLiteral("REAL.P12");
        QTest::newRow("correction without number") << QStringLiteral("REAL.P") << QString();
        QTest::newRow("correction with a letter too many") << QStringLiteral("REAL.PP1") << QString();
        QTest::newRow("other") << QStringLiteral("ACK.EXE") << QString();
        QTest::newRow("backup") << QStringLiteral("ACK.INI.bak") << QString();
        QTest::newRow("no name") << QStringLiteral(".P01") << QString();
        QTest::newRow("path") << QStringLiteral("../ACK.INI") << QString();
    }

    void names()
    {
        QFETCH(const QString, name);
        QTEST(canonicalName(name), "canonical");
    }
};

QTEST_GUILESS_MAIN(TestStationText)
#include "tst_stationtext.moc"
