#include "core/devices/usmisn/usmisnprotocol.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;

/// Every answer that manual 002 prints in section 3. Line breaks of the print are left out, quirks are
/// not: addresses in one and in three digits, numbers in ten and in eleven, the missing slash of GetInfo.
class TstUsmisnProtocol : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void identity();
    void calibration();
    void channels();
    void address();
    void echoes_data();
    void echoes();
    void values_data();
    void values();
    void valueErrors_data();
    void valueErrors();
    void signsOfPositiveNumbers_data();
    void signsOfPositiveNumbers();
    void records();
    void checksum();
    void badFields_data();
    void badFields();
};

namespace {

using Q = Instruction;

Question asked(Instruction instruction, int address = 123)
{
    return {address, "001", instruction};
}

Value printedValue()
{
    Value value;
    value.channel = {123456701};
    value.value = -2.48289;
    value.variation = 0.0086;
    value.temperature = 26.33;
    value.description = QStringLiteral("Angle_X");
    value.gain = 1;
    value.voltage = 5;
    return value;
}

/// The message of \a bytes, as a line finds it.
QByteArray found(const QByteArray &bytes, const Question &question)
{
    const Scan scan = scanAnswer(bytes, question);
    return scan.state == Scan::State::Complete ? bytes.mid(scan.skip, scan.length) : QByteArray();
}

} // namespace

void TstUsmisnProtocol::identity()
{
    const QByteArray serial = found("\n%/R/123/001/GetSerial/01234567/%\r\n", asked(Q::GetSerial));
    QCOMPARE(serial, QByteArray("%/R/123/001/GetSerial/01234567/%"));
    QCOMPARE(*decodeSerial(serial, asked(Q::GetSerial)), 1234567U);
    const QByteArray type = found("\n%/R/123/001/GetType/028/%\r\n", asked(Q::GetType));
    QCOMPARE(*decodeType(type, asked(Q::GetType)), inclinometerType);
    const QByteArray version = found("\n%/R/123/001/GetProgVersion/14.04.17/%\r\n", asked(Q::GetProgVersion));
    QCOMPARE(*decodeProgVersion(version, asked(Q::GetProgVersion)), QDate(2017, 4, 14));
}

void TstUsmisnProtocol::calibration()
{
    const QByteArray date = found("\n%/R/123/001/GetDateCalibration/00000042839/%\r\n", asked(Q::GetDateCalibration));
    QCOMPARE(*decodeDateCalibration(date, asked(Q::GetDateCalibration)), QDate(2017, 4, 14));
    const QByteArray count =
        found("\n%/R/123/001/GetCountCalibration/00000000002/%\r\n", asked(Q::GetCountCalibration));
    QCOMPARE(*decodeCountCalibration(count, asked(Q::GetCountCalibration)), 2U);
}

/// Printed without the slash of the end marker.
void TstUsmisnProtocol::channels()
{
    const Question question = asked(Q::GetInfo);
    const QString type = QStringLiteral("A");
    const QString units = QStringLiteral("Grad");
    const QByteArray x = found("\n%/R/123/001/GetInfo/0280002801,A,Grad,Angle_X%\r\n", question);
    QCOMPARE(x, QByteArray("%/R/123/001/GetInfo/0280002801,A,Grad,Angle_X%"));
    const Channel channelOfX{{280002801}, type, units, QStringLiteral("Angle_X")};
    QVERIFY(**decodeInfo(x, question) == channelOfX);
    QCOMPARE(channelOfX.id.serial(), 2800028U);
    QCOMPARE(channelOfX.id.channel(), channelX);
    const QByteArray y = found("\n%/R/123/001/GetInfo/0280002802,A,Grad,Angle_Y%\r\n", question);
    const Channel channelOfY{{280002802}, type, units, QStringLiteral("Angle_Y")};
    QVERIFY(**decodeInfo(y, question) == channelOfY);
    QCOMPARE(channelOfY.id.channel(), channelY);
    const QByteArray end = found("\n%/R/123/001/GetInfo/End/%\r\n", question);
    QVERIFY(!decodeInfo(end, question)->has_value());
    // As the syntax of the same section has it.
    const QByteArray whole = found("\n%/R/123/001/GetInfo/0280002801,A,Grad,Angle_X/%\r\n", question);
    QVERIFY(**decodeInfo(whole, question) == channelOfX);
}

void TstUsmisnProtocol::address()
{
    const QByteArray own = found("\n%/R/123/001/GetAddress/123/%\r\n", asked(Q::GetAddress));
    QCOMPARE(*decodeAddress(own, asked(Q::GetAddress)), 123);
    const QByteArray all = found("\n%/R/000/001/GetAddress/123/%\r\n", asked(Q::GetAddress, 0));
    QCOMPARE(*decodeAddress(all, asked(Q::GetAddress, 0)), 123);
    QCOMPARE(addressOf(all, asked(Q::GetAddress, 0)), everybody);
    const QByteArray record = found("\n%/R/123/001/GetRecord/End/%\r\n", asked(Q::GetRecord, 0));
    QCOMPARE(addressOf(record, asked(Q::GetRecord, 0)), 123);
}

void TstUsmisnProtocol::echoes_data()
{
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<int>("instruction");
    QTest::addColumn<QByteArray>("printed");
    QTest::addColumn<QString>("fault");
    const auto row = [](const char *printed, Instruction instruction, const char *data, const char *fault = "") {
        QTest::newRow(printed) << QByteArray(data) << int(instruction) << QByteArray(printed)
                               << QString::fromLatin1(fault);
    };
    row("\n%/R/123/001/SetAddress/32/%\r\n", Q::SetAddress, "32");
    row("\n%/R/123/001/SetAddress/032/%\r\n", Q::SetAddress, "32");
    row("\n%/R/123/001/SetAddress/33/%\r\n", Q::SetAddress, "32", "bad reply");
    row("\n%/R/123/001/SetAddress/ErrorData/%\r\n", Q::SetAddress, "ABC", "refused");
    row("\n%/R/123/001/SetPortSettings/19200,N,1/%\r\n", Q::SetPortSettings, "19200,N,1");
    row("\n%/R/123/001/SetPortSettings/19200,E,1/%\r\n", Q::SetPortSettings, "19200,N,1", "bad reply");
    row("\n%/R/123/001/SetPortSettings/19200,N/%\r\n", Q::SetPortSettings, "19200,N,1", "bad reply");
    row("\n%/R/123/001/SetPortSettings/ErrorData/%\r\n", Q::SetPortSettings, "0,0,0", "refused");
    row("\n%/R/123/001/ResetPortSettings//%\r\n", Q::ResetPortSettings, "");
    row("\n%/R/123/001/StartCycle/1483267255, 1483267265,3600,30/%\r\n", Q::StartCycle,
        "1483267255,1483267265,3600,30");
    row("\n%/R/123/001/StartCycle/ErrorData/%\r\n", Q::StartCycle, "1483267255,1483267265,0,30", "refused");
    row("\n%/R/123/001/StopCycle//%\r\n", Q::StopCycle, "");
}

void TstUsmisnProtocol::echoes()
{
    QFETCH(QByteArray, data);
    QFETCH(int, instruction);
    QFETCH(QByteArray, printed);
    QFETCH(QString, fault);
    const Ask ask{asked(static_cast<Instruction>(instruction)), data};
    const auto echo = decodeEcho(found(printed, ask.question), ask);
    QCOMPARE(echo ? QString() : faultName(echo.fault()), fault);
}

void TstUsmisnProtocol::values_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<QByteArray>("printed");
    QTest::addColumn<Value>("expected");
    QTest::newRow("not stored")
        << 123
        << QByteArray("\n%/R/123/001/GetValue/00000000000,00123456701,0000000000,-0002.48289,0000.00860,26.33,A,Grad,"
                      "Angle_X,001,5/% \r\n")
        << printedValue();
    Value out = printedValue();
    out.state = ValueState::OutOfRange;
    out.value = 0;
    out.variation = 0;
    QTest::newRow("out of range")
        << 123
        << QByteArray("\n%/R/123/001/GetValue/00000000000,00123456701,00000000000,OutOfRange,0000.00000,26.33,A,Grad,"
                      "Angle_X,001,5/% \r\n")
        << out;
    QTest::newRow("by channel id")
        << 0
        << QByteArray("\n%/R/0/001/GetValue/0000000000,00123456701,00000000000,-0002.48289,0000.00860,26.33,A,Grad,"
                      "Angle_X,001,5/% \r\n")
        << printedValue();
    Value stored = printedValue();
    stored.timestamp = 1483267255;
    stored.measurement = 45612;
    QTest::newRow("stored")
        << 123
        << QByteArray("\n%/R/123/001/GetValue/1483267255,00123456701,00000045612,-0002.48289,0000.00860,26.33,A,Grad,"
                      "Angle_X,001,5/% \r\n")
        << stored;
}

void TstUsmisnProtocol::values()
{
    QFETCH(int, address);
    QFETCH(QByteArray, printed);
    QFETCH(Value, expected);
    const Question question = asked(Q::GetValue, address);
    const auto value = decodeValue(found(printed, question), question);
    QVERIFY(value);
    QVERIFY(*value == expected);
    QCOMPARE(value->channel.serial(), 1234567U);
    QCOMPARE(value->channel.channel(), channelX);
}

void TstUsmisnProtocol::valueErrors_data()
{
    QTest::addColumn<QByteArray>("printed");
    QTest::addColumn<int>("state");
    QTest::newRow("sensor") << QByteArray("\n%/R/123/001/GetValue/ErrorSensor/% \r\n") << int(ValueState::ErrorSensor);
    QTest::newRow("channel") << QByteArray("\n%/R/123/001/GetValue/ErrorCH/% \r\n") << int(ValueState::ErrorChannel);
    QTest::newRow("data") << QByteArray("\n%/R/123/001/GetValue/ErrorData/% \r\n") << int(ValueState::ErrorData);
}

void TstUsmisnProtocol::valueErrors()
{
    QFETCH(QByteArray, printed);
    QFETCH(int, state);
    Value expected;
    expected.state = static_cast<ValueState>(state);
    const auto value = decodeValue(found(printed, asked(Q::GetValue)), asked(Q::GetValue));
    QVERIFY(value);
    QVERIFY(*value == expected);
}

void TstUsmisnProtocol::signsOfPositiveNumbers_data()
{
    QTest::addColumn<QByteArray>("field");
    QTest::addColumn<double>("expected");
    QTest::newRow("plus") << QByteArray("+0002.48289") << 2.48289;
    QTest::newRow("blank") << QByteArray(" 0002.48289") << 2.48289;
    QTest::newRow("nothing") << QByteArray("0002.48289") << 2.48289;
    QTest::newRow("minus") << QByteArray("-0002.48289") << -2.48289;
    QTest::newRow("zero") << QByteArray("-0000.00000") << 0.0;
}

void TstUsmisnProtocol::signsOfPositiveNumbers()
{
    QFETCH(QByteArray, field);
    QFETCH(double, expected);
    const QByteArray message =
        "%/R/123/001/GetValue/0,00123456702,0," + field + ",0000.00860,-05.20,A,Grad,Angle_Y,001,5/%";
    const auto value = decodeValue(message, asked(Q::GetValue));
    QVERIFY(value);
    QCOMPARE(value->value, expected);
    QCOMPARE(value->temperature, -5.2);
    QCOMPARE(value->channel.channel(), channelY);
}

void TstUsmisnProtocol::records()
{
    struct Row
    {
        const char *printed;
        qint64 timestamp;
        quint32 measurement;
        double value;
        double variation;
        double temperature;
    };
    const Row rows[] = {
        {"\n%/R/123/001/GetRecord/1483267255,00123456701,00000045612,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5/"
         "%\r\n",
         1483267255, 45612, -2.48289, 0.0086, 26.33},
        {"\n%/R/123/001/GetRecord/1483267232,00123456701,00000045610,-0002.48356,0000.00870,26.30,A,Grad,Angle_X,001,5/"
         "%\r\n",
         1483267232, 45610, -2.48356, 0.0087, 26.30},
        {"\n%/R/123/001/GetRecord/1483267240,00123456701,00000045611,-0002.48124,0000.00865,26.35,A,Grad,Angle_X,001,5/"
         "%\r\n",
         1483267240, 45611, -2.48124, 0.00865, 26.35},
        {"\n%/R/123/001/GetRecord/1483267210,00123456701,00000045610,-0002.48152,0000.00863,26.20,A,Grad,Angle_X,001,5/"
         "%\r\n",
         1483267210, 45610, -2.48152, 0.00863, 26.20},
    };
    for (const int address : {123, 0}) {
        const Question question = asked(Q::GetRecord, address);
        for (const Row &row : rows) {
            Value expected = printedValue();
            expected.timestamp = row.timestamp;
            expected.measurement = row.measurement;
            expected.value = row.value;
            expected.variation = row.variation;
            expected.temperature = row.temperature;
            const auto record = decodeRecord(found(row.printed, question), question);
            QVERIFY(record && *record);
            QVERIFY(**record == expected);
        }
        const auto end = decodeRecord(found("\n%/R/123/001/GetRecord/End/% \r\n", question), question);
        QVERIFY(end && !*end);
        const auto error = decodeRecord(found("\n%/R/123/001/GetRecord/ErrorData/% \r\n", question), question);
        QVERIFY(error.fault() == Fault::Refused);
    }
}

void TstUsmisnProtocol::checksum()
{
    const QByteArray answer = found("\n%/R/123/001/GetCRC/3002295620/%\r\n", asked(Q::GetCrc));
    QCOMPARE(*decodeCrc(answer, asked(Q::GetCrc)), 3002295620U);
    QCOMPARE(crcOf("%/R/123/001/GetSerial/01234567/%"), 3002295620U);
    QCOMPARE(crcOf("123456789"), 0xCBF43926U); // the check value of CRC-32
    const QByteArray never = found("\n%/R/123/001/GetCRC/0000000000/%\r\n", asked(Q::GetCrc));
    QCOMPARE(*decodeCrc(never, asked(Q::GetCrc)), 0U);
}

void TstUsmisnProtocol::badFields_data()
{
    QTest::addColumn<QByteArray>("fields");
    const auto row = [](const char *name, const char *fields) { QTest::newRow(name) << QByteArray(fields); };
    row("ten fields", "0,1,0,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001");
    row("twelve fields", "0,1,0,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5,5");
    row("letter in the value", "0,1,0,-0002.4828O,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("exponent", "0,1,0,1e5,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("not a number", "0,1,0,nan,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("two points", "0,1,0,1.2.3,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("two signs", "0,1,0,--2.5,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("no digits", "0,1,0,-.,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("empty variation", "0,1,0,-0002.48289,,26.33,A,Grad,Angle_X,001,5");
    row("negative counter", "0,1,-1,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("counter beyond 32 bits", "0,1,4294967296,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("thirteen digits", "0000000000000,1,0,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5");
    row("unknown keyword", "ErrorXY");
    row("nothing", "");
}

void TstUsmisnProtocol::badFields()
{
    QFETCH(QByteArray, fields);
    const QByteArray value = "%/R/123/001/GetValue/" + fields + "/%";
    QVERIFY(decodeValue(value, asked(Q::GetValue)).fault() == Fault::BadReply);
    const QByteArray record = "%/R/123/001/GetRecord/" + fields + "/%";
    QVERIFY(decodeRecord(record, asked(Q::GetRecord)).fault() == Fault::BadReply);
    const QByteArray type = "%/R/123/001/GetType/" + fields + "/%";
    QVERIFY(!decodeType(type, asked(Q::GetType)));
}

QTEST_GUILESS_MAIN(TstUsmisnProtocol)
#include "tst_usmisnprotocol.moc"
