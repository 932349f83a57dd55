#include "core/line/serialline.h"
#include "core/line/tcpline.h"
#include "tests/support/cpushare.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include <atomic>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

Scan scanLine(QByteArrayView bytes)
{
    const qsizetype end = bytes.indexOf('\n');
    return end < 0 ? Scan::incomplete() : Scan::complete(0, end + 1);
}

const Exchange hello{QByteArrayLiteral("hello\n"), scanLine, 500ms, 500ms, 0us};

/// The master side of a pty that echoes every line back in capitals, in a thread of its own.
class Tty
{
public:
    Tty()
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY))
    {
        ::grantpt(m_master);
        ::unlockpt(m_master);
        m_name = QString::fromLocal8Bit(::ptsname(m_master));
        m_slave = ::open(::ptsname(m_master), O_RDWR | O_NOCTTY);
        termios settings{};
        ::tcgetattr(m_slave, &settings);
        ::cfmakeraw(&settings);
        ::tcsetattr(m_slave, TCSANOW, &settings);
        m_thread = std::thread([this] { run(); });
    }

    ~Tty() { vanish(); }

    void vanish()
    {
        m_isEnding = true;
        if (m_thread.joinable()) {
            m_thread.join();
            ::close(m_slave);
            ::close(m_master);
        }
    }

    QString name() const { return m_name; }
    speed_t speed() const
    {
        termios settings{};
        ::tcgetattr(m_slave, &settings);
        return ::cfgetospeed(&settings);
    }

private:
    void run()
    {
        while (!m_isEnding) {
            pollfd waiting{m_master, POLLIN, 0};
            if (::poll(&waiting, 1, 10) <= 0) {
                continue;
            }
            char buffer[256];
            const auto got = ::read(m_master, buffer, sizeof buffer);
            const QByteArray answer = QByteArray(buffer, std::max<qsizetype>(got, 0)).toUpper();
            [[maybe_unused]] const auto sent =
                ::write(m_master, answer.constData(), static_cast<size_t>(answer.size()));
        }
    }

    int m_master;
    int m_slave = -1;
    QString m_name;
    std::atomic_bool m_isEnding{false};
    std::thread m_thread;
};

} // namespace

class TestRealLines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void serialExchange()
    {
        Tty tty;
        SerialLine line(tty.name(), {}, 100ms);
        QVERIFY(line.open());
        for (int i = 0; i < 20; ++i) {
            const auto answer = line.exchange(hello);
            QVERIFY(answer);
            QCOMPARE(*answer, QByteArrayLiteral("HELLO\n"));
        }
    }

    void serialPortThatVanishesIsClosedAtOnce()
    {
        Tty tty;
        SerialLine line(tty.name(), {}, 100ms);
        QVERIFY(line.open());
        QVERIFY(line.exchange(hello));
        tty.vanish();
        const auto answer = line.exchange(hello);
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::Closed);
        QVERIFY(!line.isOpen());
        QVERIFY(!line.lastError().text.isEmpty());
        const CpuShare share;
        QTest::qWait(300);
        QVERIFY(!share.spins());
    }

    /// As when the adapter is lost while a device is looked for at other settings.
    void openedAgainAsConfigured()
    {
        Tty tty;
        LineConfig config;
        config.baudRate = 9600;
        SerialLine line(tty.name(), config, 100ms);
        QVERIFY(line.open());
        QVERIFY(line.setPort({115200, Parity::None, StopBits::One}));
        QCOMPARE(tty.speed(), speed_t{B115200});
        line.close();
        QVERIFY(line.setPort({9600, Parity::None, StopBits::One}).fault() == Fault::Closed);
        QVERIFY(line.open());
        QCOMPARE(tty.speed(), speed_t{B9600});
        QCOMPARE(line.port()->baudRate, 9600);
    }

    void serialPortThatVanishesBetweenTurnsIsClosed()
    {
        Tty tty;
        SerialLine line(tty.name(), {}, 100ms);
        QVERIFY(line.open());
        QVERIFY(line.exchange(hello));
        tty.vanish();
        const CpuShare share;
        QTRY_VERIFY(!line.isOpen());
        QTest::qWait(300);
        QVERIFY(!share.spins());
    }

    void tcpExchange()
    {
        std::atomic_int port{0};
        std::atomic_bool mayEnd{false};
        std::thread server([&] {
            QTcpServer listener;
            listener.listen(QHostAddress::LocalHost);
            port = listener.serverPort();
            listener.waitForNewConnection(5000);
            std::unique_ptr<QTcpSocket> peer(listener.nextPendingConnection());
            for (int i = 0; i < 2 && peer && peer->waitForReadyRead(5000); ++i) {
                peer->write(peer->readAll().toUpper());
                peer->waitForBytesWritten(1000);
            }
            peer.reset();
            while (!mayEnd) {
                std::this_thread::sleep_for(5ms);
            }
        });
        QTRY_VERIFY(port != 0);
        TcpLine line(QStringLiteral("127.0.0.1"), static_cast<quint16>(port.load()), 100ms);
        QVERIFY(line.open());
        for (int i = 0; i < 2; ++i) {
            const auto answer = line.exchange(hello);
            QVERIFY(answer);
            QCOMPARE(*answer, QByteArrayLiteral("HELLO\n"));
        }
        const auto after = line.exchange(hello);
        QVERIFY(!after);
        QCOMPARE(after.fault(), Fault::Closed);
        QVERIFY(!line.isOpen());
        mayEnd = true;
        server.join();
    }
};

QTEST_GUILESS_MAIN(TestRealLines)
#include "tst_reallines.moc"
