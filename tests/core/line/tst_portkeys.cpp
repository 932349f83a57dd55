#include "core/config/inifile.h"
#include "core/config/serverconfig.h"
#include "core/line/openline.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

#include <optional>
#include <thread>

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

/// A pty that nobody reads, under the name of a port in a folder of ports.
class SilentPort
{
public:
    explicit SilentPort(const QString &link)
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY))
    {
        ::grantpt(m_master);
        ::unlockpt(m_master);
        const char *name = ::ptsname(m_master);
        m_slave = ::open(name, O_RDWR | O_NOCTTY);
        QFile::link(QString::fromLocal8Bit(name), link);
    }
    ~SilentPort()
    {
        ::close(m_slave);
        ::close(m_master);
    }
    Q_DISABLE_COPY_MOVE(SilentPort)

    termios settings() const
    {
        termios settings{};
        ::tcgetattr(m_slave, &settings);
        return settings;
    }

private:
    int m_master;
    int m_slave = -1;
};

LineConfig portOf(const QByteArray &keys)
{
    const QByteArray ini = "[Common]\nNumOfPorts=1\n[Port1]\nOn=1\nNum=7\n" + keys;
    return readServerConfig(IniFile::fromBytes(ini)).config.lines.value(0);
}

/// More than the buffers of a port or a socket hold.
const QByteArray flood(16'000'000, 'x');

} // namespace

/// The keys of a port: each from the file to the settings of a tty (manual 000, section 5; spec/gorizont.md, section 1).
/// A pty knows 8 bits without parity only: that it refuses others shows that it was asked.
class TestPortKeys : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder.emplace();
        m_port.emplace(m_folder->filePath(QStringLiteral("COM7")));
    }
    void cleanup()
    {
        m_line.reset();
        m_port.reset();
    }

    void numIsTheNameOfThePort()
    {
        QVERIFY(open({}));
        QVERIFY(!open("Device=/nonexistent/port\n")); // wins
        QVERIFY(open("Device=" + m_folder->filePath(QStringLiteral("COM7")).toLocal8Bit() + '\n'));
    }

    void baudRate_data()
    {
        QTest::addColumn<QByteArray>("keys");
        QTest::addColumn<speed_t>("speed");
        QTest::newRow("default") << QByteArray() << speed_t(B115200);
        QTest::newRow("9600") << QByteArray("BaudRate=9600\n") << speed_t(B9600);
        QTest::newRow("57600") << QByteArray("BaudRate=57600\n") << speed_t(B57600);
    }

    void baudRate()
    {
        QFETCH(QByteArray, keys);
        QVERIFY(open(keys));
        QTEST(::cfgetospeed(&settings()), "speed");
        QTEST(::cfgetispeed(&settings()), "speed");
    }

    void stopBits()
    {
        QVERIFY(open("StopBits=1\n"));
        QVERIFY(!(settings().c_cflag & CSTOPB));
        QVERIFY(open("StopBits=2\n"));
        QVERIFY(settings().c_cflag & CSTOPB);
    }

    void dataBitsAndParity_data()
    {
        QTest::addColumn<QByteArray>("keys");
        QTest::addColumn<bool>("isPossible");
        QTest::newRow("8N") << QByteArray("DataBits=8\nParity=N\n") << true;
        QTest::newRow("7N") << QByteArray("DataBits=7\n") << false;
        QTest::newRow("8E") << QByteArray("Parity=E\n") << false;
    }

    void dataBitsAndParity()
    {
        QFETCH(QByteArray, keys);
        QTEST(open(keys), "isPossible");
    }

    /// The one trace of it that a pty keeps.
    void oddParity()
    {
        QVERIFY(open("Parity=N\n"));
        QVERIFY(!(settings().c_cflag & PARODD));
        QVERIFY(open("Parity=O\n"));
        QVERIFY(settings().c_cflag & PARODD);
    }

    void rs485IsAskedOfTheAdapter()
    {
        QVERIFY(open("RS485=0\n"));
        QVERIFY(!open("RS485=1\n"));
        QVERIFY2(m_line->lastError().text.contains(u"RS485"), qPrintable(m_line->lastError().text));
        QVERIFY(!m_line->isOpen());
    }

    /// TOWCom, TOWDat: a port that does not take the bytes is broken, but not before.
    void writeTimeout_data()
    {
        QTest::addColumn<bool>("isTcp");
        QTest::newRow("serial") << false;
        QTest::newRow("TCP") << true;
    }

    void writeTimeout()
    {
        QFETCH(bool, isTcp);
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const QByteArray tcp = "Device=tcp://127.0.0.1:" + QByteArray::number(server.serverPort()) + '\n';
        QVERIFY(open(isTcp ? tcp : QByteArray()));
        QElapsedTimer timer;
        timer.start();
        const auto sent = m_line->send(flood, 400ms, 0us);
        QVERIFY(!sent);
        QCOMPARE(sent.fault(), Fault::Closed);
        QVERIFY2(timer.elapsed() >= 400, qPrintable(QString::number(timer.elapsed())));
        QVERIFY(!m_line->isOpen());
        QCOMPARE(m_line->writeErrors(), 1u);
    }

    /// PPauseTick: the end of the program is heard in the middle of a write, too.
    void aWriteIsInterrupted_data() { writeTimeout_data(); }

    void aWriteIsInterrupted()
    {
        QFETCH(bool, isTcp);
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const QByteArray tcp = "Device=tcp://127.0.0.1:" + QByteArray::number(server.serverPort()) + '\n';
        QVERIFY(open(isTcp ? tcp : QByteArray()));
        std::thread other([this] {
            std::this_thread::sleep_for(100ms);
            m_line->interrupt();
        });
        const auto sent = m_line->send(flood, 60s, 0us); // as long as the test may last
        other.join();
        QVERIFY(!sent);
        QCOMPARE(sent.fault(), Fault::Cancelled);
    }

private:
    bool open(const QByteArray &keys)
    {
        m_line.reset();
        m_line = makeLine(portOf(keys), {m_folder->path()}, 50ms);
        return static_cast<bool>(m_line->open());
    }

    const termios &settings()
    {
        m_settings = m_port->settings();
        return m_settings;
    }

    std::optional<QTemporaryDir> m_folder;
    std::optional<SilentPort> m_port;
    std::unique_ptr<Line> m_line;
    termios m_settings{};
};

QTEST_GUILESS_MAIN(TestPortKeys)
#include "tst_portkeys.moc"
