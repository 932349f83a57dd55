#include "core/line/serialline.h"

#include "core/line/serialformat.h"

#include <QCoreApplication>
#include <QFile>

#ifdef Q_OS_LINUX
#include <linux/serial.h>
#include <sys/ioctl.h>
#endif

namespace gorizont {

namespace {

PortSettings ofConfig(const LineConfig &config)
{
    return {config.baudRate, config.parity, config.stopBits};
}

/// Asks the driver of the adapter to switch the direction itself; false where it cannot.
bool enableRs485([[maybe_unused]] QSerialPort &port)
{
#ifdef Q_OS_LINUX
    serial_rs485 settings{};
    settings.flags = SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND;
    return ioctl(port.handle(), TIOCSRS485, &settings) == 0;
#else
    return port.setRequestToSend(false);
#endif
}

} // namespace

SerialLine::SerialLine(const QString &device, const LineConfig &config, std::chrono::milliseconds pauseTick)
    : Line(pauseTick)
    , m_config(config)
    , m_settings(ofConfig(config))
{
    m_port.setPortName(device);
    // Between two turns the event loop watches the port; without this it would report a vanished one without end.
    QObject::connect(
        &m_port, &QSerialPort::errorOccurred, &m_port,
        [this] {
            if (m_port.isOpen() && hasFailed()) {
                closeBroken();
            }
        },
        Qt::QueuedConnection);
}

SerialLine::~SerialLine() = default;

Result<void> SerialLine::open()
{
    m_port.clearError();
    m_settings = ofConfig(m_config);
    if (!m_port.open(QIODevice::ReadWrite) || !configure(m_settings)) {
        return closeBroken();
    }
    if (m_config.isRs485 && !enableRs485(m_port)) {
        m_port.close();
        setLastError(
            QSerialPort::UnsupportedOperationError,
            QCoreApplication::translate("gorizont::SerialLine", "the adapter does not know RS485=1"));
        return Fault::Closed;
    }
    m_port.clear();
    return {};
}

bool SerialLine::configure(const PortSettings &port)
{
    return m_port.setBaudRate(port.baudRate)
        && m_port.setDataBits(static_cast<QSerialPort::DataBits>(m_config.dataBits))
        && m_port.setParity(qtParity(port.parity)) && m_port.setStopBits(qtStopBits(port.stopBits))
        && m_port.setFlowControl(QSerialPort::NoFlowControl);
}

void SerialLine::close()
{
    m_port.close();
}

bool SerialLine::isOpen() const
{
    return m_port.isOpen();
}

std::optional<PortSettings> SerialLine::port() const
{
    return m_settings;
}

Result<void> SerialLine::setPort(const PortSettings &port)
{
    if (!m_port.isOpen()) {
        return Fault::Closed;
    }
    if (!configure(port)) {
        m_port.clearError();
        return configure(m_settings) ? Fault::Refused : closeBroken();
    }
    m_settings = port;
    m_port.clear(QSerialPort::Input);
    return {};
}

Result<void> SerialLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout)
{
    if (!m_port.isOpen()) {
        return Fault::Closed;
    }
    m_port.write(bytes.data(), bytes.size());
    const QDeadlineTimer deadline(timeout);
    while (m_port.bytesToWrite() > 0) {
        if (isInterrupted()) {
            m_port.clear(QSerialPort::Output);
            return Fault::Cancelled;
        }
        if (!m_port.waitForBytesWritten(sliceUntil(deadline)) && (hasFailed() || deadline.hasExpired())) {
            // A port that does not take a few bytes in time is broken too.
            return closeBroken();
        }
    }
    return hasFailed() ? Result<void>(closeBroken()) : Result<void>();
}

Result<QByteArray> SerialLine::readSome(std::chrono::microseconds timeout)
{
    if (!m_port.isOpen()) {
        return Fault::Closed;
    }
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(timeout);
    const bool hasBytes = m_port.bytesAvailable() > 0 || m_port.waitForReadyRead(static_cast<int>(wait.count()));
    if (!hasBytes && hasFailed()) {
        return closeBroken();
    }
    const QByteArray bytes = m_port.readAll();
    // A zero-length read of a vanished device is silent in later Qt versions; its node is not.
    if (bytes.isEmpty() && wait.count() > 0 && !isNodePresent()) {
        return closeBroken();
    }
    return bytes;
}

bool SerialLine::isNodePresent() const
{
#ifdef Q_OS_WIN
    return true;
#else
    const QString name = m_port.portName();
    return QFile::exists(name.startsWith(u'/') ? name : QStringLiteral("/dev/") + name);
#endif
}

bool SerialLine::hasFailed() const
{
    return m_port.error() != QSerialPort::NoError && m_port.error() != QSerialPort::TimeoutError;
}

/// What the system says of a device that was pulled out helps nobody ("inappropriate ioctl").
Fault SerialLine::closeBroken()
{
    if (isNodePresent()) {
        setLastError(m_port.error(), m_port.errorString());
    } else {
        setLastError(
            QSerialPort::ResourceError, QCoreApplication::translate("gorizont::SerialLine", "there is no such device"));
    }
    m_port.close();
    return Fault::Closed;
}

} // namespace gorizont
