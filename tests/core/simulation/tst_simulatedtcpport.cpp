#include "core/devices/lvims/lvimsdriver.h"
#include "core/devices/lvims/lvimssimulator.h"
#include "core/engine/lineworker.h"
#include "core/line/openline.h"
#include "core/simulation/simulatedtcpport.h"
#include "core/values/readingjson.h"
#include "tests/core/devices/lvimsbench.h"
#include "tests/support/fakeline.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTcpSocket>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

LineConfig siteLine()
{
    LineConfig line;
    line.index = 1;
    line.com = 4;
    line.isOn = true;
    line.device = u"tcp://127.0.0.1:0"_s;
    line.sensors = {vimsSensor()};
    return line;
}

/// A simulated port in a thread of its own, as the program of the simulator has it.
class Module
{
public:
    Module()
        : m_port(new SimulatedTcpPort(siteLine(), {1, {}, 0us}))
    {
        m_port->moveToThread(&m_thread);
        QObject::connect(&m_thread, &QThread::finished, m_port, &QObject::deleteLater);
        m_thread.start();
        plug();
        here([this] {
            m_simulator = dynamic_cast<lvims::Simulator *>(m_port->bus().devices().front().get());
            m_simulator->module().setUpdatePeriod(0s);
        });
    }
    ~Module()
    {
        m_thread.quit();
        m_thread.wait();
    }
    Q_DISABLE_COPY_MOVE(Module)

    template <typename Work> void here(Work work)
    {
        QMetaObject::invokeMethod(m_port, work, Qt::BlockingQueuedConnection);
    }
    void plug()
    {
        here([this] {
            m_isListening = m_port->plug();
            m_number = m_port->port();
        });
    }
    void unplug()
    {
        here([this] { m_port->unplug(); });
    }
    template <typename Change> void change(Change change)
    {
        here([this, change] { change(m_simulator->module()); });
    }

    bool isListening() const { return m_isListening; }
    quint16 number() const { return m_number; }
    LineConfig line() const
    {
        LineConfig line = siteLine();
        line.device = u"tcp://127.0.0.1:%1"_s.arg(m_number);
        return line;
    }

private:
    QThread m_thread;
    SimulatedTcpPort *m_port;
    lvims::Simulator *m_simulator = nullptr;
    bool m_isListening = false;
    quint16 m_number = 0;
};

std::unique_ptr<Driver> driverOf()
{
    DriverSettings settings;
    settings.sensor = vimsSensor();
    settings.timing.readCommand = 3s;
    return lvims::makeDriver(settings);
}

/// A line worker in a thread of its own, and what it said.
struct Polling
{
    explicit Polling(const LineConfig &line)
        : worker(settingsOf(line), [line] { return makeLine(line, {}, 100ms); })
        , journal(&worker, &LineWorker::journal)
        , readings(&worker, &LineWorker::readingsReady)
    {
        worker.moveToThread(&thread);
        QObject::connect(&thread, &QThread::started, &worker, &LineWorker::start);
        QObject::connect(&thread, &QThread::finished, &worker, &LineWorker::stop, Qt::DirectConnection);
        thread.start();
    }
    ~Polling()
    {
        worker.interrupt();
        thread.quit();
        thread.wait();
    }
    Q_DISABLE_COPY_MOVE(Polling)

    static PollingSettings settingsOf(const LineConfig &line)
    {
        PollingSettings settings;
        settings.line = line;
        settings.timing.run = 20ms;
        settings.timing.readCommand = 3s;
        settings.timing.reopenPause = 50ms;
        settings.timing.closePause = 50ms;
        return settings;
    }

    QString said(int index) { return journal.value(index).value(0).value<JournalEntry>().text; }

    Reading last() const
    {
        const Readings batch = readings.isEmpty() ? Readings() : readings.last().at(0).value<Readings>();
        return batch.isEmpty() ? Reading() : batch.constFirst();
    }

    bool hasAnswer() const { return last().isAnswer && last().vibration; }

    LineWorker worker;
    QSignalSpy journal;
    QSignalSpy readings;
    QThread thread;
};

} // namespace

/// A module behind a socket: the same line worker, the same words in the journal as for a serial port.
class TstSimulatedTcpPort : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyOnThisComputer()
    {
        QVERIFY(SimulatedTcpPort::isOwn(u"tcp://127.0.0.1:502"_s));
        QVERIFY(SimulatedTcpPort::isOwn(u"TCP://localhost:502"_s));
        QVERIFY(!SimulatedTcpPort::isOwn(u"tcp://192.168.1.10:502"_s));
        QVERIFY(!SimulatedTcpPort::isOwn(u"tcp://example.org:502"_s));
        QVERIFY(!SimulatedTcpPort::isOwn(u"/dev/ttyS0"_s));
        QVERIFY(!SimulatedTcpPort::isOwn(QString()));
    }

    void aPollOverASocket()
    {
        Module module;
        QVERIFY(module.isListening());
        const auto line = makeLine(module.line(), {}, 100ms);
        QVERIFY(line->open());
        const auto driver = driverOf();
        const auto first = driver->poll(*line);
        QVERIFY(first && first->vibration);
        QCOMPARE(first->vibration->channels.size(), 4);
        const quint64 sent = line->bytesSent();
        const auto second = driver->poll(*line);
        QVERIFY(second);
        QCOMPARE(*second, *first);
        QCOMPARE(line->bytesSent() - sent, 12u); // nothing changed: one request
    }

    void severalClientsAtOnce()
    {
        Module module;
        const auto one = makeLine(module.line(), {}, 100ms);
        const auto other = makeLine(module.line(), {}, 100ms);
        QVERIFY(one->open());
        QVERIFY(other->open());
        const auto driver = driverOf();
        const auto otherDriver = driverOf();
        for (int i = 0; i < 3; ++i) {
            QVERIFY(driver->poll(*one));
            QVERIFY(otherDriver->poll(*other));
        }
    }

    void requestsInPieces()
    {
        Module module;
        QTcpSocket socket;
        socket.connectToHost(u"127.0.0.1"_s, module.number());
        QVERIFY(socket.waitForConnected());
        for (const char byte : hex("00 07 00 00 00 06 01 03 00 61 00 01")) {
            socket.write(&byte, 1);
            socket.flush();
        }
        QByteArray heard;
        while (heard.size() < 11 && socket.waitForReadyRead(3000)) {
            heard += socket.readAll();
        }
        QCOMPARE(heard, hex("00 07 00 00 00 05 01 03 02 00 02")); // DEVMODE: at work
    }

    void aLengthWithoutSenseEndsTheConnection()
    {
        Module module;
        QTcpSocket socket;
        socket.connectToHost(u"127.0.0.1"_s, module.number());
        QVERIFY(socket.waitForConnected());
        socket.write(hex("00 01 00 00 FF FA 01"));
        QVERIFY(socket.waitForDisconnected(3000));
    }

    void aReadingAsJson()
    {
        Module module;
        Polling polling(module.line());
        QTRY_VERIFY(polling.hasAnswer());
        const QByteArray json = readingToJson(polling.last(), vimsSensor(), module.line());
        const QJsonObject object = QJsonDocument::fromJson(json).object();
        QCOMPARE(object.value(u"type"_s).toString(), u"L-VIMS"_s);
        QCOMPARE(object.value(u"port"_s).toString(), u"COM4"_s);
        QCOMPARE(object.value(u"status"_s).toInt() >> 12, 0);
        QCOMPARE(object.value(u"relays"_s).toArray().size(), 8);
        const QJsonArray channels = object.value(u"channels"_s).toArray();
        QCOMPARE(channels.size(), 4);
        const QJsonObject measured = channels.at(3).toObject().value(u"measurements"_s).toArray().at(1).toObject();
        QCOMPARE(measured.value(u"type"_s).toInt(), 2);
        QVERIFY(measured.value(u"value"_s).toDouble() > 0.1);
    }

    /// A restart cuts the connection; the port is opened again and everything is read anew.
    void aRestartOfTheModule()
    {
        Module module;
        Polling polling(module.line());
        QTRY_VERIFY(polling.hasAnswer());
        QCOMPARE(polling.said(0), u"COM4 is open"_s);
        module.change([](lvims::SimulatedModule &simulated) { simulated.restart(1s); });
        QTRY_VERIFY(polling.journal.size() >= 3);
        QVERIFY(polling.said(1).startsWith(u"COM4 is gone ("_s));
        QCOMPARE(polling.said(2), u"COM4 is open"_s);
        polling.readings.clear();
        QTRY_VERIFY(polling.hasAnswer());
    }

    /// Unplugged for longer: one line in the journal when it goes, one when it is back, none in between.
    void unpluggedAndBack()
    {
        Module module;
        Polling polling(module.line());
        QTRY_VERIFY(polling.hasAnswer());
        module.unplug();
        QTRY_VERIFY(polling.journal.size() >= 2);
        QTest::qWait(300);
        QCOMPARE(polling.journal.size(), 2);
        QVERIFY(polling.said(1).startsWith(u"COM4 is gone ("_s));
        module.plug();
        QVERIFY(module.isListening());
        QTRY_COMPARE(polling.journal.size(), 3);
        QCOMPARE(polling.said(2), u"COM4 is open"_s);
    }
};

QTEST_GUILESS_MAIN(TstSimulatedTcpPort)
#include "tst_simulatedtcpport.moc"
