#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

/// Check values of the catalogue of parametrised CRC algorithms, and whole frames of the manufacturers' documents.
class TstChecksums : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void checkValues();
    void ofNothing();
    void ccittOfFrames_data();
    void ccittOfFrames();
    void modbusOfFrames_data();
    void modbusOfFrames();
    void xorOfFrames();
    void sumWrapsAround();
    void reading();
    void appending();
};

void TstChecksums::checkValues()
{
    const QByteArray check("123456789");
    QCOMPARE(crc16CcittFalse(check), quint16(0x29B1));
    QCOMPARE(crc16Modbus(check), quint16(0x4B37));
    QCOMPARE(xorSum(check), quint8(0x31));
    QCOMPARE(byteSum(check), quint8(0xDD));
}

void TstChecksums::ofNothing()
{
    QCOMPARE(crc16CcittFalse({}), quint16(0xFFFF));
    QCOMPARE(crc16Modbus({}), quint16(0xFFFF));
    QCOMPARE(xorSum({}), quint8(0));
    QCOMPARE(byteSum({}), quint8(0));
}

/// spec/and3.md, "Requests"; the low byte comes first.
void TstChecksums::ccittOfFrames_data()
{
    QTest::addColumn<QByteArray>("frame");
    for (const char *text :
         {"01 C9 00 00 12 4A", "02 C9 00 00 CE D1", "01 24 04 00 B6 64", "01 CB 00 01 53 34", "01 32 65 01 4F BD",
          "01 DD 00 00 B1 D5", "01 CE 00 00 82 CF", "01 63 42 63 24 07"}) {
        QTest::newRow(text) << hex(text);
    }
}

void TstChecksums::ccittOfFrames()
{
    QFETCH(QByteArray, frame);
    QCOMPARE(crc16CcittFalse(frame.chopped(2)), *readLittle<quint16>(frame, frame.size() - 2));
}

/// spec/ind3.md, "Modbus RTU"; "MODBUS over serial line" 1.02, 6.2.2 (02 07: 41 12).
void TstChecksums::modbusOfFrames_data()
{
    QTest::addColumn<QByteArray>("frame");
    for (const char *text : {"01 04 00 00 00 04 F1 C9", "02 07 41 12"}) {
        QTest::newRow(text) << hex(text);
    }
}

void TstChecksums::modbusOfFrames()
{
    QFETCH(QByteArray, frame);
    QCOMPARE(crc16Modbus(frame.chopped(2)), *readLittle<quint16>(frame, frame.size() - 2));
}

void TstChecksums::xorOfFrames()
{
    QCOMPARE(xorSum(hex("9B 01 01 6A 77 80 38 C2 00")), quint8(0xFC));
    QCOMPARE(xorSum(hex("9B 01 01 6A 77 80 38 C2 00 FC")), quint8(0));
}

void TstChecksums::sumWrapsAround()
{
    QCOMPARE(byteSum(hex("FF FF 02")), quint8(0));
    QCOMPARE(byteSum(hex("E2 7C 00 72 32 81 7D")), quint8(0));
}

void TstChecksums::reading()
{
    const QByteArray bytes = hex("01 02 03 04");
    QCOMPARE(*readLittle<quint16>(bytes, 1), quint16(0x0302));
    QCOMPARE(*readBig<quint16>(bytes, 1), quint16(0x0203));
    QCOMPARE(*readLittle<quint32>(bytes, 0), quint32(0x04030201));
    QCOMPARE(*readBig<quint32>(bytes, 0), quint32(0x01020304));
    for (const qsizetype outside : {qsizetype(-1), qsizetype(1), qsizetype(4), qsizetype(5)}) {
        QVERIFY(!readLittle<quint32>(bytes, outside));
        QVERIFY(!readBig<quint32>(bytes, outside));
    }
}

void TstChecksums::appending()
{
    QByteArray bytes;
    appendLittle(bytes, quint16(0x0102));
    appendBig(bytes, quint32(0x03040506));
    appendByte(bytes, 0x1FF);
    QCOMPARE(bytes, hex("02 01 03 04 05 06 FF"));
    QCOMPARE(byteAt(bytes, 6), quint8(0xFF));
}

QTEST_GUILESS_MAIN(TstChecksums)
#include "tst_checksums.moc"
