#include "ui/models/health.h"
#include "ui/models/statetext.h"

#include "tests/ui/samplesite.h"

#include <QtTest>

using namespace gorizont;

class TestHealth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sensor_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<LineState>("line");
        QTest::addColumn<bool>("hasAnswered");
        QTest::addColumn<Health>("health");
        QTest::addColumn<QString>("text");
        const auto row = [](const char *name, int status, LineState line, bool answered, Health health,
                            const char *text) {
            QTest::newRow(name) << status << line << answered << health << QString::fromUtf8(text);
        };
        row("good", 0x0000, LineState::Open, true, Health::Good, "Answering");
        row("off", 0x0F00, LineState::Open, false, Health::Off, "Polling is off");
        row("port off", 0x1700, LineState::Off, false, Health::Off, "The port is off");
        row("waiting", 0x0700, LineState::Open, false, Health::Unknown, "Waiting for the first answer");
        row("service", 0x0700, LineState::Service, true, Health::Service, "Service mode, polling is suspended");
        row("off in service", 0x0F00, LineState::Service, false, Health::Off, "Polling is off");
        row("port error", 0x2700, LineState::Lost, true, Health::Error, "Port error");
        row("silent", 0x3700, LineState::Open, true, Health::Error, "No answer");
        row("fan", 0xA014, LineState::Open, true, Health::Error, "The fan does not work");
        row("restarted", 0x0720, LineState::Open, true, Health::Warning,
            "Answering: restarted, tilt is not ready, temperature is not ready, acceleration is not ready");
        row("heating", 0x0014, LineState::Open, true, Health::Warning, "Answering: the thermostat has not settled");
        row("overrun", 0x0180, LineState::Open, true, Health::Warning,
            "Answering: samples were lost, acceleration is not ready");
        row("legacy bit of restart", 0x0020, LineState::Open, true, Health::Good, "Answering");
    }
    void sensor()
    {
        QFETCH(int, status);
        QFETCH(LineState, line);
        QFETCH(bool, hasAnswered);
        QFETCH(Health, health);
        QFETCH(QString, text);
        SensorRegistry::Sensor sensor;
        sensor.config = test::sampleConfig().lines.first().sensors.first();
        sensor.reading.status = static_cast<quint16>(status);
        if (hasAnswered) {
            sensor.reading.answeredAt = std::chrono::steady_clock::now();
        }
        QCOMPARE(sensorHealth(sensor, line), health);
        QCOMPARE(statetext::sensor(sensor, line), text);
    }

    /// A collapsed tree must not hide a sensor in trouble.
    void portShowsItsSensors()
    {
        QCOMPARE(portHealth(LineState::Open, Health::Good), Health::Good);
        QCOMPARE(portHealth(LineState::Open, Health::Error), Health::Warning);
        QCOMPARE(portHealth(LineState::OpenFailed, Health::Error), Health::Error);
        QCOMPARE(portHealth(LineState::Service, Health::Service), Health::Service);
        QCOMPARE(portHealth(LineState::Off, Health::Off), Health::Off);
    }

    void counts()
    {
        SensorRegistry registry(test::sampleConfig().lines, {});
        const SteadyTime now = std::chrono::steady_clock::now();
        Reading silent = test::tiltReading(3, 0, 0, now);
        silent.status = 0x3700;
        registry.updateLine(test::openLine(1, now));
        registry.updateLine(test::openLine(2, now));
        registry.update({test::sampleReading(now), test::tiltReading(2, 0, 0, now), silent});
        const HealthCounts counts = countHealth(registry);
        QCOMPARE(counts[Health::Good], 2);
        QCOMPARE(counts[Health::Error], 1);
        QCOMPARE(counts[Health::Off], 1);
        QCOMPARE(statetext::counts(counts), QStringLiteral("Sensors good: 2, with errors: 1, off: 1"));
        QCOMPARE(siteHealth(registry), Health::Warning);
    }
};

QTEST_GUILESS_MAIN(TestHealth)
#include "tst_health.moc"
