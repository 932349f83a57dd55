#include "ui/models/propertymodel.h"
#include "ui/models/settingsproperties.h"
#include "ui/models/stateproperties.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

QString text(const Properties &properties)
{
    QStringList lines;
    for (const Property &property : properties) {
        lines += property.isSection ? property.name : property.name + QStringLiteral(" | ") + property.value;
    }
    return lines.join(u'\n');
}

} // namespace

class TestProperties : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void port()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        LineStatus status = test::openLine(1, now - 3600s);
        status.pollingAt = now - 238s;
        status.bytesSent = 10;
        status.bytesReceived = 20;
        status.failedOpens = 1;
        status.writeErrors = 2;
        status.readErrors = 3;
        status.crcErrors = 4;
        status.lastErrorCode = 12;
        status.lastError = QStringLiteral("timed out");
        registry.updateLine(status);
        QCOMPARE(
            text(portProperties(registry.lines().front(), now)),
            QStringLiteral("Comment | Moxa UPort 1151\n"
                           "State | Open, polling\n"
                           "Polling time | 0:03:58\n"
                           "Time since opening | 1:00:00\n"
                           "Bytes sent | 10\n"
                           "Bytes received | 20\n"
                           "Attempts to open | 1\n"
                           "Write errors | 2\n"
                           "Read errors | 3\n"
                           "CRC errors | 4\n"
                           "Code of the last error | 12 (timed out)"));
    }

    void sensor()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        registry.update({test::sampleReading(now)});
        registry.setPacketsSaved(1, 179);
        QCOMPARE(
            text(sensorProperties(registry.sensors().front(), LineState::Open, now)),
            QStringLiteral("Comment | АН1 (АН-Д3, TMP05, подогрев)\n"
                           "State | Answering\n"
                           "Angles Mx, My, degrees (arc-seconds) | -1.000 +0.756 (-3599.5 +2720.5)\n"
                           "Accelerations Ax, Ay, mm/s² | 7.67 270.0 (2.19|0.00 2.19) 179:179 (5728) 179\n"
                           "Temperature T, °C | 21.38\n"
                           "Wind speed U, V, m/s | —\n"
                           "Thermostat, % (rev/s) | 45.3 (41.0)\n"
                           "Status word | 0010 0100 0000 1111 : 1100 1100 0000 0000\n"
                           "Polling period, s | 1.002|0.031|00:00\n"
                           "Read errors | 3\n"
                           "CRC errors | 2\n"
                           "Firmware version | —\n"
                           "System clock | —\n"
                           "Power of the heater | —\n"
                           "Power of the fan | —\n"
                           "Address and command of the transducer | —\n"
                           "Response time of the transducer | —"));
    }

    /// CanInfo=1: what comes stands below the rows of the manual; a type that is not asked has no such rows.
    void sensorThatSaysSomethingOfItself()
    {
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        DeviceInformation information;
        information.number = 1;
        information.firmware = QStringLiteral("2.3.12");
        information.systemClock = 40'000'000;
        information.heaterPower = 452;
        information.innerTransducer = 513;
        information.responseTime = 250;
        registry.setInformation(information);
        const SteadyTime now = std::chrono::steady_clock::now();
        QCOMPARE(
            text(sensorProperties(registry.sensors().front(), LineState::Open, now).mid(11)),
            QStringLiteral("Firmware version | 2.3.12\n"
                           "System clock | 40000000\n"
                           "Power of the heater | 452\n"
                           "Power of the fan | —\n"
                           "Address and command of the transducer | 513\n"
                           "Response time of the transducer | 250"));
        QCOMPARE(sensorProperties(registry.sensors()[1], LineState::Open, now).size(), 11);
    }

    void sensorWithoutAnswer()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const Properties rows =
            sensorProperties(registry.sensors().front(), LineState::Opening, std::chrono::steady_clock::now());
        QCOMPARE(rows.size(), 17);
        for (int row = 2; row <= 8; ++row) {
            QCOMPARE(rows.at(row).value, QStringLiteral("—"));
        }
    }

    void serverSettingsInTheOrderOfTheManual()
    {
        QCOMPARE(
            text(serverSettings(test::sampleConfig())),
            QStringLiteral("[Server]\nComment | Высотное здание\nIP port | 502\n"
                           "[Timers]\nTmUpdateInt | 100 ms\nTmRun | 1000 ms\nTmStart | 1000 ms\nTmSave | 1000 ms\n"
                           "[Pauses]\nPPauseTick | 100 ms\nPReOpen | 5000 ms\nPClose | 5000 ms\nPExit | 1000 ms\n"
                           "[Sleeps]\nSAdrChange | 16 ms\nSIdle | 1 ms\nSRError | 0 ms\nSCRCError | 600 ms\n"
                           "[TimeOuts]\nTORCom | 200 ms\nTOWCom | 100 ms\nTORDat | 4000 ms\nTOWDat | 2000 ms\n"
                           "[Errors]\nNumRErrSrs | 10\nNumCErrSrs | 10\n"
                           "[More]\nSave to files | yes\nRecords shown | 60\nRecords cleared | 1\n"
                           "Hide to the tray at the start | no\nWarn at the end of work | no\n"
                           "Allow a second copy | no\nAllow adjustment | no\nAccelerometer's buffer | 8192 packets"));
    }

    void portAndSensorSettings()
    {
        const ServerConfig config = test::sampleConfig();
        QCOMPARE(
            text(lineSettings(config, config.lines.first())),
            QStringLiteral("[Port]\nComment | Moxa UPort 1151\nSwitched on | yes\nNumber | COM4\n"
                           "BaudRate | 115200 baud"));
        QCOMPARE(
            text(sensorSettings(config, config.lines.first().sensors.first())),
            QStringLiteral("[Sensor]\nComment | АН1 (АН-Д3, TMP05, подогрев)\nPolling | yes\n"
                           "Number on the site | 1\nAddress on the line | 12\nSerial number | 804\n"
                           "[Adjustment]\nOffset Mx, degrees (arc-seconds) | +0.028 (+100.0)\n"
                           "Offset My, degrees (arc-seconds) | -1.000 (-3600.0)\nOffset T, °C | +0.50\n"
                           "Inversion of axis Y | yes\nRotation of axis X, degrees | +90.000\n"
                           "Date of installation | 21.01.2017\nDate of the last adjustment | 24.01.2017\n"
                           "Remark | Линия 1, терминал 120 Ом"));
    }

    void replacedValuesAreMarked()
    {
        ServerConfig config = test::sampleConfig();
        config.replaced.insert(QStringLiteral("sleeps/scrcerr"), QStringLiteral("-5"));
        config.replaced.insert(QStringLiteral("port1/adr1"), QStringLiteral("300"));
        QStringList marked;
        for (const Property &property :
             serverSettings(config) + sensorSettings(config, config.lines.first().sensors.first())) {
            if (property.isReplaced) {
                marked += property.name + u' ' + property.note;
            }
        }
        QCOMPARE(
            marked,
            QStringList(
                {QStringLiteral("SCRCError the file gives “-5”, which cannot be used"),
                 QStringLiteral("Address on the line the file gives “300”, which cannot be used")}));
    }

    void modelAnnouncesOnlyWhatChanged()
    {
        PropertyModel model(false);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        model.setProperties({{QStringLiteral("a"), QStringLiteral("1")}, {QStringLiteral("b"), QStringLiteral("2")}});
        QCOMPARE(reset.size(), 1);
        model.setProperties({{QStringLiteral("a"), QStringLiteral("1")}, {QStringLiteral("b"), QStringLiteral("3")}});
        QCOMPARE(reset.size(), 1);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed.at(0).at(0).toModelIndex(), model.index(1, PropertyModel::Value));
        QCOMPARE(test::modelText(model, true), QStringLiteral("Parameter | Value\na | 1\nb | 3"));
    }
};

QTEST_MAIN(TestProperties)
#include "tst_properties.moc"
