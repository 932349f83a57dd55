#include "core/modbus/modbusanswer.h"
#include "core/modbus/registerdocument.h"
#include "tests/core/modbus/modbussite.h"

#include <QRegularExpression>
#include <QTest>

#include <bit>
#include <cmath>

using namespace gorizont;
using namespace gorizont::test;

namespace {

ServerConfig site(ModbusPacking packing, int base)
{
    ServerConfig server;
    server.modbusPort = 1502;
    server.modbusPacking = packing;
    server.modbusBase = base;
    server.lines = modbusSite().lines;
    server.lines[0].com = 4;
    server.lines[0].sensors[2].place = QStringLiteral("Floor 1 | *left* [A_B]");
    server.lines[0].sensors[2].address = 12;
    return server;
}

/// Different for every sensor and quantity, and exact in the registers of all units: tilt in whole 0.001°, that is 3.6″.
double set(int number, const QString &quantity)
{
    static const QHash<QString, double> values{
        {QStringLiteral("tilt_x"), -0.25},
        {QStringLiteral("tilt_y"), 1.5},
        {QStringLiteral("temperature"), 20.25},
        {QStringLiteral("heater"), 50.5},
        {QStringLiteral("fan"), 30},
        {QStringLiteral("accel_max"), 7.75},
        {QStringLiteral("accel_direction"), 90},
        {QStringLiteral("accel_max_x"), -1.25},
        {QStringLiteral("accel_max_y"), -7.5},
        {QStringLiteral("accel_rms"), 2.5},
        {QStringLiteral("accel_rms_x"), 1.75},
        {QStringLiteral("accel_rms_y"), 0.75},
        {QStringLiteral("raw_status"), 4660},
        {QStringLiteral("raw_mode"), 22136},
        {QStringLiteral("answers"), 100000},
        {QStringLiteral("read_errors"), 200000},
        {QStringLiteral("crc_errors"), 300000},
        {QStringLiteral("packets_measured"), 400000},
        {QStringLiteral("packets_read"), 7000},
        {QStringLiteral("period"), 1},
        {QStringLiteral("exchange"), 0.5},
        {QStringLiteral("link_x"), 12.5},
        {QStringLiteral("link_y"), -0.25},
        {QStringLiteral("displacement_x"), 640},
        {QStringLiteral("displacement_y"), -32},
        {QStringLiteral("wind_speed"), 4.75},
        {QStringLiteral("wind_direction"), 187.5},
        {QStringLiteral("wind_max"), 9.25},
        {QStringLiteral("wind_deviation"), 0.75},
        {QStringLiteral("pressure"), 745.25},
        {QStringLiteral("humidity"), 68},
        {QStringLiteral("digital"), 2147483648},
        {QStringLiteral("time"), 1517999583456},
    };
    return values.value(quantity) + number;
}

Weather weatherOf(int number)
{
    const auto parameter = [number](QChar code, const char *quantity) {
        WeatherParameter made;
        made.code = code;
        made.mean = set(number, QString::fromLatin1(quantity));
        return made;
    };
    WeatherParameter speed = parameter(u'M', "wind_speed");
    speed.maximum = set(number, QStringLiteral("wind_max"));
    speed.deviation = set(number, QStringLiteral("wind_deviation"));
    return {
        static_cast<quint32>(set(number, QStringLiteral("digital"))),
        {parameter(u'A', "wind_direction"), speed, parameter(u'P', "pressure"), parameter(u'H', "humidity")},
        {}};
}

Reading readingOf(int number)
{
    const auto value = [number](const char *quantity) { return set(number, QString::fromLatin1(quantity)); };
    Reading reading;
    reading.number = number;
    reading.isAnswer = true;
    reading.time = UtcTime(std::chrono::milliseconds(static_cast<qint64>(value("time"))));
    reading.answeredAt = SteadyTime::clock::now();
    reading.status = 0x0010; // all is valid
    reading.tilt = Tilt{3600 * value("tilt_x"), 3600 * value("tilt_y")};
    reading.temperature = value("temperature");
    reading.heaterPower = value("heater");
    reading.fanFrequency = value("fan");
    AccelStatistics accelerations;
    accelerations.maximum = value("accel_max");
    accelerations.direction = value("accel_direction");
    accelerations.maximumX = value("accel_max_x");
    accelerations.maximumY = value("accel_max_y");
    accelerations.rms = value("accel_rms");
    accelerations.rmsX = value("accel_rms_x");
    accelerations.rmsY = value("accel_rms_y");
    reading.acceleration = accelerations;
    reading.displacement = LinkDisplacement{
        {value("link_x"), value("link_y")}, Displacement{value("displacement_x"), value("displacement_y")}};
    reading.weather = weatherOf(number);
    reading.rawStatus = static_cast<quint16>(value("raw_status"));
    reading.rawMode = static_cast<quint16>(value("raw_mode"));
    reading.ring =
        RingProgress{static_cast<quint64>(value("packets_measured")), static_cast<quint64>(value("packets_read"))};
    reading.counters = {
        static_cast<quint64>(value("answers")), static_cast<quint64>(value("read_errors")),
        static_cast<quint64>(value("crc_errors"))};
    reading.period = std::chrono::microseconds(static_cast<qint64>(1e6 * value("period")));
    reading.exchange = std::chrono::microseconds(static_cast<qint64>(1e6 * value("exchange")));
    return reading;
}

/// What modbusSite() and the readings above make of a register that is not simply a measured value.
std::optional<double> known(int number, const QString &field)
{
    static const QHash<QString, double> head{
        {QStringLiteral("magic"), 0x474F525A}, {QStringLiteral("version"), 1},   {QStringLiteral("directory"), 100},
        {QStringLiteral("directory_step"), 4}, {QStringLiteral("blocks"), 3000}, {QStringLiteral("block_step"), 100},
        {QStringLiteral("channels"), 12},      {QStringLiteral("sensors"), 4},   {QStringLiteral("current"), 4},
        {QStringLiteral("switched_off"), 0},   {QStringLiteral("code_0"), 4}};
    if (number == 0) {
        return field.startsWith(u"code_") ? head.value(field, 0) : head.value(field, -1);
    }
    const bool hasAcceleration = number == 2 || number == 6;
    static const QHash<int, double> flags{{1, 0x7FF}, {2, 0x7FF}, {4, 0x7FD}, {6, 0x7FB}};
    const QHash<QString, double> own{
        {QStringLiteral("number"), number},
        {QStringLiteral("port"), number == 6 ? 2 : 1},
        {QStringLiteral("address"), number == 1 ? 12 : 1},
        {QStringLiteral("type"), hasAcceleration ? 2 : 1},
        {QStringLiteral("flags"), flags.value(number)},
        {QStringLiteral("status"), 0x0010},
        {QStringLiteral("quantities"), hasAcceleration ? 7 : 1},
        {QStringLiteral("tilt_x_arcsec"), 3600 * set(number, QStringLiteral("tilt_x"))},
        {QStringLiteral("tilt_y_arcsec"), 3600 * set(number, QStringLiteral("tilt_y"))}};
    return own.contains(field) ? own.value(field) : set(number, field);
}

/// The number in \a bytes as a reader of the document alone would take it: the letters say where which byte is.
double decoded(const QByteArray &bytes, const QString &type, const QString &order)
{
    quint64 bits = 0;
    for (qsizetype letter = 0; letter < bytes.size(); ++letter) {
        bits = bits << 8 | static_cast<quint8>(bytes.at(order.indexOf(QChar(u'A' + static_cast<char16_t>(letter)))));
    }
    if (type == QStringLiteral("float32")) {
        return double{std::bit_cast<float>(static_cast<quint32>(bits))};
    }
    return type == QStringLiteral("int16") ? static_cast<qint16>(bits) : static_cast<double>(bits);
}

QByteArray ask(const UnitImages &images, int unit, int function, int address, int count)
{
    const QByteArray request = QStringLiteral("000100000006%1%2%3%4")
                                   .arg(unit, 2, 16, QLatin1Char('0'))
                                   .arg(function, 2, 16, QLatin1Char('0'))
                                   .arg(address, 4, 16, QLatin1Char('0'))
                                   .arg(count, 4, 16, QLatin1Char('0'))
                                   .toLatin1();
    AnswerBuffer answer;
    answerRequests(QByteArray::fromHex(request), images, answer);
    return QByteArray(answer.constData(), answer.size()).sliced(9);
}

/// A row of a table of registers, as it stands in the document.
struct Row
{
    int unit = 0;
    int number = 0; ///< 0: of the head
    QStringList cells; ///< without the column 4x
    QString holding; ///< the column 4x; empty: there is none
};

QList<Row> rowsOf(const QString &document)
{
    static const QRegularExpression unitTitle(QStringLiteral("^## Unit (\\d+)"));
    static const QRegularExpression sensorName(QStringLiteral("No\\. (\\d+) \\("));
    static const QRegularExpression cellEnd(QStringLiteral("(?<!\\\\)\\|"));
    QList<Row> rows;
    Row current;
    for (const QString &line : document.split(u'\n')) {
        if (const auto match = unitTitle.match(line); match.hasMatch()) {
            current.unit = match.captured(1).toInt();
            current.number = 0;
        } else if (line.startsWith(u"## ")) {
            current.unit = 0;
        } else if (line.startsWith(u"####")) {
            current.number = sensorName.match(line).captured(1).toInt();
        }
        QStringList cells = line.split(cellEnd);
        bool isRegister = false;
        cells.value(1).trimmed().toInt(&isRegister);
        if (current.unit == 0 || cells.size() < 10 || !isRegister) {
            continue;
        }
        cells.removeFirst();
        cells.removeLast();
        for (QString &cell : cells) {
            cell = cell.trimmed().remove(u'`');
        }
        Row row = current;
        row.holding = current.unit == 1 ? cells.takeAt(2) : QString();
        if (cells.size() == 10) {
            row.number = sensorName.match(cells.last()).captured(1).toInt();
        }
        row.cells = cells;
        rows.append(row);
    }
    return rows;
}

QString numbered(char kind, int address)
{
    const QString digits = QString::number(address + 1);
    return QLatin1Char(kind) + QString(digits.size() < 4 ? 4 - digits.size() : 0, u'0') + digits;
}

bool isClock(const QString &field)
{
    return field == u"server_time" || field == u"uptime" || field == u"age" || field == u"slots";
}

} // namespace

/// The document says the truth: everything it says of a register is tried on the server's own answers.
class TestRegisterDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRegisterHoldsWhatTheDocumentSays_data()
    {
        QTest::addColumn<int>("packing");
        QTest::addColumn<int>("base");
        QTest::newRow("by type") << static_cast<int>(ModbusPacking::ByType) << 0;
        QTest::newRow("from register 1") << static_cast<int>(ModbusPacking::ByType) << 1;
        QTest::newRow("by number") << static_cast<int>(ModbusPacking::ByNumber) << 0;
    }

    void everyRegisterHoldsWhatTheDocumentSays()
    {
        QFETCH(const int, packing);
        QFETCH(const int, base);
        const ServerConfig server = site(static_cast<ModbusPacking>(packing), base);
        UnitImages images(modbusConfig(server));
        for (const int number : {1, 2, 4, 6}) {
            images.update(readingOf(number));
        }
        const QList<Row> rows = rowsOf(registerDocument(server));
        // Units 3 and 6: the channel word, 4 sensors × 4, 2 sensors × 5. Unit 1: head 25, 4 × (3 + 43).
        QCOMPARE(rows.size(), 1 + 16 + 1 + 10 + 25 + 184);
        QSet<std::pair<int, int>> seen;
        for (const Row &row : rows) {
            const int address = row.cells.at(0).toInt();
            const QString field = row.cells.at(3);
            const QByteArray where =
                QStringLiteral("unit %1 register %2 %3").arg(row.unit).arg(address).arg(field).toUtf8();
            QVERIFY2(!seen.contains({row.unit, address}), where.constData());
            seen.insert({row.unit, address});
            QCOMPARE(row.cells.at(1), numbered('3', address));
            const int count = row.cells.at(2).toInt();
            const QByteArray bytes = ask(images, row.unit, 4, address, count);
            QCOMPARE(bytes.size(), 2 * count);
            QCOMPARE(row.cells.at(5).size(), bytes.size());
            if (row.unit == 1) {
                QCOMPARE(row.holding, numbered('4', address));
            }
            if (isClock(field)) {
                continue;
            }
            if (row.unit == 1) {
                QCOMPARE(ask(images, 1, 3, address, count), bytes);
            }
            const double scale = row.cells.at(6).toDouble();
            const double value = decoded(bytes, row.cells.at(4), row.cells.at(5)) * scale;
            const double expected = known(row.number, field).value_or(0);
            QVERIFY2(
                std::abs(value - expected) < 1e-6 * std::max(1.0, std::abs(expected)),
                where + ": " + QByteArray::number(value) + " for " + QByteArray::number(expected));
        }
    }

    void clocksAreWhereTheDocumentSays()
    {
        const ServerConfig server = site(ModbusPacking::ByType, 0);
        UnitImages images(modbusConfig(server));
        images.update(readingOf(2));
        int clocks = 0;
        for (const Row &row : rowsOf(registerDocument(server))) {
            const QString field = row.cells.at(3);
            if (!isClock(field)) {
                continue;
            }
            ++clocks;
            const QByteArray bytes = ask(images, row.unit, 4, row.cells.at(0).toInt(), row.cells.at(2).toInt());
            const double value = decoded(bytes, row.cells.at(4), row.cells.at(5));
            if (field == u"server_time") {
                const auto now = std::chrono::system_clock::now().time_since_epoch();
                QVERIFY(std::abs(value - std::chrono::duration<double, std::milli>(now).count()) < 100000);
            } else if (field == u"slots") {
                QCOMPARE(value, 4.0);
            } else if (field == u"age" && row.number != 2) {
                QCOMPARE(value, 4294967295.0);
            } else {
                QVERIFY2(value < 100000, qPrintable(field));
            }
        }
        QCOMPARE(clocks, 3 + 4);
    }

    void theExamplesAreTheseBytes()
    {
        // N=1 in unit 3: −264.0″ ÷ 3.6 → −73 = FFB7h, −6644.6″ → −1846 = F8CAh, no temperature, neither temperature nor
        // accelerations: 0300h; low byte first. Registers 2…5, 3 + 8 bytes behind the length.
        // N=2 in unit 6: 767, 2700, 0, 219 as in modbussite.h, all valid: 0000h.
        // N=1 in unit 1, register 3016 = BC8h: −264 = −1.03125 × 2^8 → C3840000h; −6644.6 = −1.62221679… × 2^12, fraction
        // .62221679… × 2^23 = 5219533 = 4FA4CDh → C5CFA4CDh.
        const QString document = registerDocument(site(ModbusPacking::ByType, 0));
        for (const char *bytes :
             {"`00 01 00 00 00 06 03 04 00 02 00 04`", "`00 01 00 00 00 0B 03 04 08 B7 FF CA F8 00 00 00 03`",
              "`00 01 00 00 00 06 06 04 00 02 00 05`", "`00 01 00 00 00 0D 06 04 0A FF 02 8C 0A 00 00 DB 00 00 00`",
              "`00 01 00 00 00 06 01 04 0B C8 00 04`", "`00 01 00 00 00 0B 01 04 08 C3 84 00 00 C5 CF A4 CD`",
              "| `B7 FF` | `tilt_x` = -73 × 0.001 ° |", "| `00 03` | `status` = 0300h |",
              "| `C5 CF A4 CD` | `tilt_y_arcsec` = -6644.6 ″ |"}) {
            QVERIFY2(document.contains(QString::fromUtf8(bytes)), bytes);
        }
    }

    void everySensorIsNamed()
    {
        const QString document = registerDocument(site(ModbusPacking::ByType, 0));
        QVERIFY(document.contains(
            QStringLiteral("| 1 |  | COM4 | 12 | Floor 1 \\| \\*left\\* \\[A\\_B\\] | yes | 2 | — | 3000 |")));
        QVERIFY(document.contains(QStringLiteral("| 6 |  | COM1 | 1 |  | no | 14 | 7 | 3300 |")));
        QVERIFY(document.contains(QStringLiteral("port 1502")));
    }

    void registersBeyond9999HaveFiveDigits()
    {
        ServerConfig server = site(ModbusPacking::ByType, 0);
        const SensorConfig model = server.lines[0].sensors[0];
        for (int number = 100; number < 200; ++number) {
            server.lines[2].sensors.append(model);
            server.lines[2].sensors.last().number = number;
        }
        const QString document = registerDocument(server);
        // Slot 69 is at 9900, slot 70 at 10000.
        QVERIFY(document.contains(QStringLiteral("| 9962 | 39963 | 49963 |")));
        QVERIFY(document.contains(QStringLiteral("| 10000 | 310001 | 410001 |")));
    }

    void anEmptySiteHasADocumentToo()
    {
        ServerConfig server;
        server.servesModbus = false;
        const QString document = registerDocument(server);
        QVERIFY(document.contains(QStringLiteral("CanModbus=0")));
        QVERIFY(document.contains(QStringLiteral("`magic`")));
        QVERIFY(!document.contains(QStringLiteral("Example")));
    }

    void whoFindsNoRoomIsNamed()
    {
        ServerConfig server = site(ModbusPacking::ByNumber, 0);
        server.lines[0].sensors[0].number = 700;
        const QString document = registerDocument(server);
        QVERIFY(document.contains(QStringLiteral("N=700")));
        QVERIFY(document.contains(QStringLiteral("| 700 |  | COM4 | 1 |  | no | 2798 | — | — |")));
    }
};

QTEST_APPLESS_MAIN(TestRegisterDocument)
#include "tst_registerdocument.moc"
