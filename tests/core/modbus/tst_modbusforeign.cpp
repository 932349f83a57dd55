#include "core/modbus/modbusserver.h"
#include "tests/core/modbus/modbussite.h"

#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QThread>

#include <array>
#include <cerrno>
#include <memory>
#include <modbus.h>

using namespace gorizont;
using namespace gorizont::test;

namespace {

struct ModbusFree
{
    void operator()(modbus_t *context) const
    {
        modbus_close(context);
        modbus_free(context);
    }
};
using Context = std::unique_ptr<modbus_t, ModbusFree>;

/// What a client that does not know of the byte order shows: every register of the blocks byte-swapped.
QList<quint16> asRegisters(const QByteArray &bytes)
{
    QList<quint16> registers;
    for (qsizetype i = 0; i + 1 < bytes.size(); i += 2) {
        registers.append(static_cast<quint16>(static_cast<quint8>(bytes[i]) << 8 | static_cast<quint8>(bytes[i + 1])));
    }
    return registers;
}

} // namespace

/// Clients of other makers against the server in its own thread: libmodbus in this process and mbpoll as a program.
class TestModbusForeign : public QObject
{
    Q_OBJECT

    QThread m_thread;
    ModbusServer *m_server = nullptr;
    quint16 m_port = 0;

    Context connectTo(int unit) const
    {
        Context context(modbus_new_tcp("127.0.0.1", m_port));
        modbus_set_slave(context.get(), unit);
        return modbus_connect(context.get()) == 0 ? std::move(context) : Context();
    }

    QByteArray poll(const QStringList &arguments) const
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(
            QStringLiteral("mbpoll"),
            QStringList{QStringLiteral("-m"), QStringLiteral("tcp"), QStringLiteral("-p"), QString::number(m_port)}
                + arguments + QStringList{QStringLiteral("-1"), QStringLiteral("127.0.0.1")});
        return process.waitForFinished(10000) ? process.readAll() : "mbpoll: " + process.errorString().toUtf8();
    }

    /// `[3]: 	0xB7FF` → B7FF, in the order of the output.
    static QList<quint16> polled(const QByteArray &output)
    {
        QList<quint16> registers;
        static const QRegularExpression line(QStringLiteral("\\[\\d+\\]:\\s+0x([0-9A-F]{4})"));
        for (auto found = line.globalMatch(QString::fromUtf8(output)); found.hasNext();) {
            registers.append(found.next().captured(1).toUShort(nullptr, 16));
        }
        return registers;
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_server = new ModbusServer(modbusSite());
        m_server->moveToThread(&m_thread);
        connect(&m_thread, &QThread::finished, m_server, &QObject::deleteLater);
        m_thread.start();
        QMetaObject::invokeMethod(
            m_server,
            [this] {
                m_server->updateReadings({sampleTilt(), sampleAcceleration()});
                m_server->updateLine(lineStatus(3, LineState::OpenFailed));
                m_server->updateLine(lineStatus(5, LineState::Lost));
                m_server->connectDevice();
                m_port = m_server->serverPort();
            },
            Qt::BlockingQueuedConnection);
        QVERIFY(m_port != 0);
    }

    void cleanupTestCase()
    {
        m_thread.quit();
        QVERIFY(m_thread.wait(5000));
    }

    void libmodbusReadsBothUnits()
    {
        std::array<quint16, 18> registers{};
        const Context tilt = connectTo(3);
        QVERIFY(tilt);
        QCOMPARE(modbus_read_input_registers(tilt.get(), 0, 18, registers.data()), 18);
        QCOMPARE(QList<quint16>(registers.begin(), registers.end()), asRegisters(tiltBlock()));
        const Context acceleration = connectTo(6);
        QVERIFY(acceleration);
        QCOMPARE(modbus_read_input_registers(acceleration.get(), 2, 5, registers.data()), 5);
        QCOMPARE(QList<quint16>(registers.begin(), registers.begin() + 5), asRegisters(accelerationBlock()).mid(2, 5));
    }

    void libmodbusUnderstandsTheExceptions()
    {
        std::array<quint16, 200> registers{};
        const Context tilt = connectTo(3);
        QVERIFY(tilt);
        QCOMPARE(modbus_read_registers(tilt.get(), 0, 1, registers.data()), -1);
        QCOMPARE(errno, EMBXILFUN);
        QCOMPARE(modbus_read_input_registers(tilt.get(), 18, 1, registers.data()), -1);
        QCOMPARE(errno, EMBXILADD);
        QCOMPARE(modbus_read_input_registers(tilt.get(), 0, 0, registers.data()), -1);
        QCOMPARE(errno, EMBXILVAL);
        QCOMPARE(modbus_write_register(tilt.get(), 0, 1), -1);
        QCOMPARE(errno, EMBXILFUN);
        const Context stranger = connectTo(7);
        QVERIFY(stranger);
        QCOMPARE(modbus_read_input_registers(stranger.get(), 0, 1, registers.data()), -1);
        QCOMPARE(errno, EMBXGTAR);
    }

    void mbpollReadsBothUnits()
    {
        const auto arguments = [](const char *unit, const char *count) {
            return QStringList{QStringLiteral("-a"),    QString::fromLatin1(unit), QStringLiteral("-t"),
                               QStringLiteral("3:hex"), QStringLiteral("-0"),      QStringLiteral("-r"),
                               QStringLiteral("0"),     QStringLiteral("-c"),      QString::fromLatin1(count)};
        };
        const QByteArray tilt = poll(arguments("3", "18"));
        QVERIFY2(polled(tilt) == asRegisters(tiltBlock()), tilt.constData());
        const QByteArray acceleration = poll(arguments("6", "12"));
        QVERIFY2(polled(acceleration) == asRegisters(accelerationBlock()), acceleration.constData());
        const QByteArray beyond = poll(arguments("6", "13"));
        QVERIFY2(beyond.contains("Illegal data address"), beyond.constData());
    }
};

QTEST_GUILESS_MAIN(TestModbusForeign)
#include "tst_modbusforeign.moc"
