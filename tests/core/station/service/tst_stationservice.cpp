#include "core/station/service/stationline.h"
#include "core/station/service/stationthread.h"
#include "tests/support/fakeline.h"

#include <QDir>
#include <QSignalSpy>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include <map>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

// All frames of this file were made with Python's struct.
const QByteArray askTwo = hex("BB 01 02 00 00 00 00 00 42");
/// U1 = 12.5 and T1 = 0, means and instantaneous values; digital input 1 is on.
const QByteArray answerTwo = hex("BB 01 00 02 02 00 00 00 40 00 00 48 41 00 00 48 41 00 00 00 00 00 00 00 00 EE");
const QByteArray askOutputs5 = hex("BB 01 01 00 05 00 00 00 3E");
const QByteArray askStation2 = hex("BB 02 02 00 00 00 00 00 41");
const QByteArray confirmed = hex("BB 01 00 00 02 00 00 00 42");
const QByteArray setTime = hex("BB 01 FF 00 00 CA 9A 3B A6"); // 1,000,000,000
/// ACK.PAR with U alone, y = 1 + x.
const QByteArray newParameters =
    hex("BB 01 FF 07 1F 00 00 00 1F 41 43 4B 2E 50 41 52 55 20 56 20 73 20 55 20 31 20 41 20 32 "
        "20 25 34 2E 31 66 20 30 20 32 30 20 2D 20 31 20 31 0A 40");
const QByteArray answerAfterwards = hex("BB 01 00 01 02 00 00 00 41 00 00 58 41 00 00 58 41 CE");
const QByteArray evilFile = hex("BB 01 FF 0A 01 00 00 00 3A 2E 2E 2F 41 43 4B 2E 50 41 52 78 1D");

const std::map<QString, QByteArray> goodFiles{
    {QStringLiteral("ACK.INI"), "1 1 x\n1 0 a\n"},
    {QStringLiteral("ACK.PAR"), "U V s U 1 A 2 %4.1f 10 15 - 0 1\nT C s T 1 A 2 %6.2f -60 60 - -50 20\n"},
    {QStringLiteral("ACK.PSE"), "1\n"},
    {QStringLiteral("ACK.FWL"), "300\n5\n0\n0\n1000\n0\n1\n0\n0\nUT\n-\nUT\n"},
    {QStringLiteral("ACK.SRC"), "a1 constant 12.5\na2 constant 2.5\nd1 constant 0\nd2 constant 1\n"},
};

/// A station in a folder of its own that listens on this computer.
class StationUnderTest
{
public:
    explicit StationUnderTest(std::map<QString, QByteArray> files = goodFiles)
    {
        for (const auto &[name, text] : files) {
            write(name, text);
        }
        StationSetup setup;
        setup.configFolder = m_folder.path();
        setup.dataFolder = m_folder.filePath(QStringLiteral("data"));
        setup.listen = {ListenAddress{}};
        m_thread = std::make_unique<StationThread>(setup);
        QObject::connect(&station(), &Station::journal, &m_context, [this](const JournalEntry &entry) {
            told += entry.text;
        });
        QObject::connect(&station(), &Station::measured, &m_context, [this](const Weather &, qint64 clock) {
            ++seconds;
            lastClock = clock;
        });
    }

    void write(const QString &name, const QByteArray &text)
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }

    QByteArray read(const QString &name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    StationThread &thread() { return *m_thread; }
    Station &station() { return m_thread->station(); }

    /// Measures for long enough that every mean is there.
    void start()
    {
        m_thread->start();
        QTRY_VERIFY_WITH_TIMEOUT(seconds >= 4, 20'000);
        QMetaObject::invokeMethod(
            &station(), [this] { m_port = station().tcpPorts().value(0); }, Qt::BlockingQueuedConnection);
    }

    std::unique_ptr<QTcpSocket> connected()
    {
        auto socket = std::make_unique<QTcpSocket>();
        socket->connectToHost(QHostAddress::LocalHost, m_port);
        return socket->waitForConnected(5000) ? std::move(socket) : nullptr;
    }

    QStringList told;
    int seconds = 0;
    qint64 lastClock = 0;

private:
    QTemporaryDir m_folder;
    QObject m_context;
    std::unique_ptr<StationThread> m_thread;
    quint16 m_port = 0;
};

/// What comes until there are as many bytes as \a size, or 5 s have passed.
QByteArray receive(QTcpSocket &socket, qsizetype size)
{
    QByteArray bytes = socket.readAll();
    while (bytes.size() < size && socket.waitForReadyRead(5000)) {
        bytes += socket.readAll();
    }
    return bytes;
}

QByteArray exchange(QTcpSocket &socket, const QByteArray &request, qsizetype size)
{
    socket.write(request);
    return receive(socket, size).toHex(' ');
}

} // namespace

class TestStationService : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersTwoClientsAtOnce();
    void setsOutputs();
    void keepsTheTimeItIsGiven();
    void takesAFileAndGoesOnWithIt();
    void writesRecords();
    void startsWithWhatIsGood();
    void isALine();
    void refusesASecondProgram();
    void dropsTheIdlestClient();
};

void TestStationService::answersTwoClientsAtOnce()
{
    StationUnderTest station;
    station.start();
    const auto one = station.connected();
    const auto two = station.connected();
    QVERIFY(one && two);
    // Pieces of one between the requests of the other.
    one->write(askTwo.first(4));
    QVERIFY(one->waitForBytesWritten(1000));
    QCOMPARE(exchange(*two, askStation2 + hex("00 BB") + askTwo, answerTwo.size()), answerTwo.toHex(' '));
    QCOMPARE(exchange(*one, askTwo.sliced(4), answerTwo.size()), answerTwo.toHex(' '));
    QCOMPARE(exchange(*one, askTwo + askTwo, 2 * answerTwo.size()), (answerTwo + answerTwo).toHex(' '));
    // Nothing was said to the other station.
    QCOMPARE(two->bytesAvailable(), 0);
    two->write(askStation2);
    QVERIFY(!two->waitForReadyRead(300));
}

void TestStationService::setsOutputs()
{
    QTemporaryDir outputs;
    auto files = goodFiles;
    for (const char *name : {"/one", "/two", "/three"}) {
        QFile file(outputs.path() + QLatin1StringView(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("-") == 1);
    }
    const QByteArray folder = QFile::encodeName(outputs.path());
    files[QStringLiteral("ACK.SRC")] +=
        "o1 file " + folder + "/one\no2 file " + folder + "/two\no3 file " + folder + "/three\n";
    StationUnderTest station(files);
    station.start();
    const auto content = [&outputs](const char *name) {
        QFile file(outputs.path() + QLatin1StringView(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const auto client = station.connected();
    QVERIFY(client);
    client->write(askOutputs5);
    QVERIFY(client->waitForReadyRead(5000));
    QCOMPARE(content("/one"), QByteArray("1"));
    QCOMPARE(content("/two"), QByteArray("0"));
    QCOMPARE(content("/three"), QByteArray("1"));
    client->write(askTwo); // control word 0
    QVERIFY(client->waitForReadyRead(5000));
    QTRY_COMPARE(content("/one"), QByteArray("0"));
}

void TestStationService::keepsTheTimeItIsGiven()
{
    StationUnderTest station;
    station.start();
    const auto client = station.connected();
    QVERIFY(client);
    QCOMPARE(exchange(*client, setTime, confirmed.size()), confirmed.toHex(' '));
    QTRY_VERIFY(station.lastClock >= 1'000'000'000 && station.lastClock < 1'000'000'060);
    QTRY_VERIFY(!station.read(QStringLiteral("data/clock.txt")).isEmpty());
    // Records of that time, by that clock.
    QTRY_VERIFY_WITH_TIMEOUT(
        station.read(QStringLiteral("data/2001_09_obj001.txt")).contains("\n2001-09-09 01:46:4"), 10'000);
}

void TestStationService::takesAFileAndGoesOnWithIt()
{
    StationUnderTest station;
    station.start();
    const auto client = station.connected();
    QVERIFY(client);
    const QByteArray before = station.read(QStringLiteral("ACK.PAR"));
    client->write(evilFile);
    QVERIFY(!client->waitForReadyRead(500));
    QCOMPARE(exchange(*client, newParameters, confirmed.size()), confirmed.toHex(' '));
    QCOMPARE(station.read(QStringLiteral("ACK.PAR")), QByteArray("U V s U 1 A 2 %4.1f 0 20 - 1 1\n"));
    QCOMPARE(station.read(QStringLiteral("ACK.PAR.bak")), before);
    // The same connection goes on; the new polynomial is in force.
    QByteArray answer;
    for (int i = 0; i < 100 && answer != answerAfterwards.toHex(' '); ++i) {
        QTest::qWait(100);
        client->write(askTwo);
        QVERIFY(client->waitForReadyRead(5000));
        answer = client->readAll().toHex(' ');
    }
    QCOMPARE(answer, answerAfterwards.toHex(' '));
    QTRY_VERIFY(station.told.join(u'\n').contains(QStringLiteral("../ACK.PAR")));
}

void TestStationService::writesRecords()
{
    auto files = goodFiles;
    files[QStringLiteral("ACK.PSE")] = "1 number\n" + QByteArray("0\n").repeated(20) + "1 SAFE\n";
    StationUnderTest station(files);
    station.start();
    QVERIFY(station.thread().stop(10s));
    const QDir data(station.thread().setup().dataFolder);
    const QStringList records = data.entryList({QStringLiteral("????_??_obj001.txt")});
    QCOMPARE(records.size(), 1);
    QFile file(data.filePath(records.constFirst()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArrayList lines = file.readAll().split('\n');
    QCOMPARE(lines.constFirst(), QByteArray(";time\tU01\tU01 min\tU01 max\tT01\tT01 min\tT01 max\tdigital"));
    QVERIFY(lines.size() >= 4);
    QVERIFY(lines.at(lines.size() - 2).endsWith("\t12.5\t12.5\t12.5\t0.00\t0.00\t0.00\t00000002"));
    const QStringList safe = QDir(data.filePath(QStringLiteral("SAFE"))).entryList({QStringLiteral("*_raw.txt")});
    QCOMPARE(safe.size(), 1);
    QVERIFY(station.read(QStringLiteral("data/SAFE/") + safe.constFirst()).contains("\t12.5\t2.5\n"));
}

/// A faulty line in every file: each is said with its place, and the good parameter is measured.
void TestStationService::startsWithWhatIsGood()
{
    auto files = goodFiles;
    files[QStringLiteral("ACK.INI")] += "1 0 r3 9600 8 1 0\n";
    files[QStringLiteral("ACK.PAR")] += "broken\n";
    files[QStringLiteral("ACK.SRC")] += "a3 wobble 1\n";
    StationUnderTest station(files);
    station.start();
    const QString told = station.told.join(u'\n');
    for (const char *place : {"ACK.INI, line 3", "ACK.PAR, line 3", "ACK.SRC, line 5"}) {
        QVERIFY2(told.contains(QLatin1StringView(place)), qPrintable(told));
    }
    const auto client = station.connected();
    QVERIFY(client);
    QCOMPARE(exchange(*client, askTwo, answerTwo.size()), answerTwo.toHex(' '));
}

void TestStationService::isALine()
{
    StationUnderTest station;
    station.start();
    StationLine line(station.station(), {}, 100ms);
    const auto anything = [](QByteArrayView bytes) {
        return bytes.isEmpty() ? Scan::incomplete() : Scan::complete(0, bytes.size());
    };
    const Exchange request{askTwo, anything, 100ms, 3000ms, 0us};
    QVERIFY(!line.exchange(request)); // closed
    QVERIFY(line.open());
    const auto answer = line.exchange(request);
    QVERIFY(answer);
    QCOMPARE(answer->toHex(' '), answerTwo.toHex(' '));
    const Exchange toOther{askStation2, anything, 100ms, 200ms, 0us};
    const auto silence = line.exchange(toOther);
    QVERIFY(!silence);
    QCOMPARE(silence.fault(), Fault::Timeout);
    QVERIFY(station.thread().stop(10s));
    QVERIFY(!line.exchange({askTwo, anything, 100ms, 200ms, 0us})); // nobody answers, nothing crashes

    StationLine refused(station.station(), QStringLiteral("it is in use"), 100ms);
    QVERIFY(!refused.open());
    QCOMPARE(refused.lastError().text, QStringLiteral("it is in use"));
}

void TestStationService::refusesASecondProgram()
{
    StationUnderTest station;
    QVERIFY(station.thread().acquire());
    StationThread second(station.thread().setup());
    QVERIFY(!second.acquire());
}

void TestStationService::dropsTheIdlestClient()
{
    StationUnderTest station;
    station.start();
    std::vector<std::unique_ptr<QTcpSocket>> clients;
    for (qsizetype i = 0; i < TcpDoor::mostClients; ++i) {
        clients.push_back(station.connected());
        QVERIFY(clients.back());
        QCOMPARE(exchange(*clients.back(), askTwo, answerTwo.size()), answerTwo.toHex(' '));
    }
    QCOMPARE(exchange(*clients.front(), askTwo, answerTwo.size()), answerTwo.toHex(' '));
    const auto another = station.connected();
    QVERIFY(another);
    QCOMPARE(exchange(*another, askTwo, answerTwo.size()), answerTwo.toHex(' '));
    QVERIFY(clients[1]->waitForDisconnected(5000));
    QCOMPARE(clients.front()->state(), QAbstractSocket::ConnectedState);
}

QTEST_GUILESS_MAIN(TestStationService)

#include "tst_stationservice.moc"
