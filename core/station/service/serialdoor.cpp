#include "core/station/service/serialdoor.h"

#include "core/line/serialformat.h"

#include <QFile>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto nodeCheck = 1s;
constexpr auto reopenPause = 5s;

/// An answer that a line has not taken when the next one comes is of no use to anybody.
constexpr qsizetype mostUnsent = 16384; ///< bytes

std::chrono::microseconds byteTime(const LineConfig &config)
{
    const int bits = 1 + config.dataBits + (config.parity == Parity::None ? 0 : 1) + 2;
    return std::chrono::microseconds(1'000'000LL * bits / std::max(config.baudRate, 1));
}

} // namespace

SerialDoor::SerialDoor(const QString &device, const LineConfig &config, Answerer answerer, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_answerer(std::move(answerer))
    , m_listener(m_answerer.isOwn, byteTime(config))
{
    m_port.setPortName(device);
    connect(&m_port, &QSerialPort::readyRead, this, &SerialDoor::onBytes);
    // Queued: closing a port from inside of its own report is not allowed. One report is enough, spec/traps.md, 4.
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialDoor::onError, Qt::QueuedConnection);
    connect(&m_watch, &QTimer::timeout, this, &SerialDoor::checkNode);
}

SerialDoor::~SerialDoor() = default;

void SerialDoor::open()
{
    m_port.clearError();
    if (!m_port.open(QIODevice::ReadWrite) || !configure()) {
        close(m_port.errorString());
        return;
    }
    m_port.clear();
    m_watch.start(nodeCheck);
    m_isTold = false;
    Q_EMIT stateChanged(true, tr("%1: open for dispatchers").arg(m_port.portName()));
}

bool SerialDoor::configure()
{
    return m_port.setBaudRate(m_config.baudRate)
        && m_port.setDataBits(static_cast<QSerialPort::DataBits>(m_config.dataBits))
        && m_port.setParity(qtParity(m_config.parity)) && m_port.setStopBits(qtStopBits(m_config.stopBits))
        && m_port.setFlowControl(QSerialPort::NoFlowControl);
}

void SerialDoor::onBytes()
{
    const QByteArray bytes = m_port.readAll();
    for (const ack::Asked &asked : m_listener.hear(bytes, std::chrono::steady_clock::now())) {
        if (m_port.bytesToWrite() > mostUnsent) {
            m_port.clear(QSerialPort::Output);
        }
        m_port.write(m_answerer.answer(asked));
    }
}

void SerialDoor::onError()
{
    const bool isHarmless = m_port.error() == QSerialPort::NoError || m_port.error() == QSerialPort::TimeoutError;
    if (m_port.isOpen() && !isHarmless) {
        close(m_port.errorString());
    }
}

void SerialDoor::checkNode()
{
    if (!m_port.isOpen()) {
        open();
    } else if (!isNodePresent()) {
        close({});
    }
}

/// What the system says of a device that was pulled out helps nobody.
void SerialDoor::close(const QString &why)
{
    const QString reason = isNodePresent() ? why : tr("there is no such device");
    m_port.close();
    m_watch.start(reopenPause);
    if (!m_isTold) {
        m_isTold = true;
        Q_EMIT stateChanged(
            false, tr("%1 is closed for dispatchers (%2) and is tried again and again").arg(m_port.portName(), reason));
    }
}

bool SerialDoor::isNodePresent() const
{
#ifdef Q_OS_WIN
    return true;
#else
    const QString name = m_port.portName();
    return QFile::exists(name.startsWith(u'/') ? name : QStringLiteral("/dev/") + name);
#endif
}

} // namespace gorizont::station
