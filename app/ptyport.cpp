#include "app/ptyport.h"

#include <QDir>
#include <QFile>
#include <QSocketNotifier>

#include <algorithm>
#include <array>

#include <cstdlib>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace gorizont {

namespace {

/// 0: one that no device of the program has.
int baudRateOf(speed_t speed)
{
    switch (speed) {
    case B110: return 110;
    case B300: return 300;
    case B600: return 600;
    case B1200: return 1200;
    case B2400: return 2400;
    case B4800: return 4800;
    case B9600: return 9600;
    case B19200: return 19200;
    case B38400: return 38400;
    case B57600: return 57600;
    case B115200: return 115200;
    default: return 0;
    }
}

} // namespace

PtyPort::PtyPort(const LineConfig &config, const SimulatedBus::Options &options, const QString &directory)
    : m_bus(config, options)
    , m_linkPath(QDir(directory).filePath(config.title()))
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &PtyPort::sendDue);
}

PtyPort::~PtyPort()
{
    unplug();
}

bool PtyPort::plug()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0) {
        return false;
    }
    const char *name = ::ptsname(m_master);
    m_slave = name ? ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
    if (m_slave < 0) {
        return false;
    }
    termios settings{};
    ::tcgetattr(m_slave, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(m_slave, TCSANOW, &settings);
    QFile::remove(m_linkPath);
    if (!QFile::link(QString::fromLocal8Bit(name), m_linkPath)) {
        return false;
    }
    m_notifier = std::make_unique<QSocketNotifier>(m_master, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &PtyPort::onRequest);
    return true;
}

void PtyPort::unplug()
{
    m_notifier.reset();
    m_timer.stop();
    m_arriving.clear();
    for (int *end : {&m_slave, &m_master}) {
        if (*end >= 0) {
            ::close(*end);
            *end = -1;
        }
    }
    QFile::remove(m_linkPath);
}

SimulatedBus::Time PtyPort::now() const
{
    return std::chrono::duration_cast<SimulatedBus::Time>(std::chrono::steady_clock::now() - m_started);
}

/// The speed and the stop bits that the host has set; a pty knows no parity.
void PtyPort::followHost()
{
    termios settings{};
    PortSettings port = m_bus.port();
    const int baudRate = ::tcgetattr(m_slave, &settings) == 0 ? baudRateOf(::cfgetospeed(&settings)) : 0;
    if (baudRate == 0) {
        return;
    }
    port.baudRate = baudRate;
    port.stopBits = settings.c_cflag & CSTOPB ? StopBits::Two : StopBits::One;
    if (port != m_bus.port()) {
        m_bus.setPort(port);
    }
}

void PtyPort::onRequest()
{
    followHost();
    std::array<char, 4096> buffer{};
    const auto got = ::read(m_master, buffer.data(), buffer.size());
    if (got <= 0) {
        return;
    }
    m_arriving += m_bus.receive(QByteArrayView(buffer.data(), got), now());
    std::stable_sort(m_arriving.begin(), m_arriving.end(), [](const auto &a, const auto &b) { return a.at < b.at; });
    planNext();
}

void PtyPort::sendDue()
{
    while (!m_arriving.isEmpty() && m_arriving.first().at <= now()) {
        const QByteArray bytes = m_arriving.takeFirst().bytes;
        [[maybe_unused]] const auto sent = ::write(m_master, bytes.constData(), static_cast<std::size_t>(bytes.size()));
    }
    planNext();
}

void PtyPort::planNext()
{
    if (!m_arriving.isEmpty()) {
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(m_arriving.first().at - now());
        m_timer.start(std::max(wait, std::chrono::milliseconds(0)));
    }
}

} // namespace gorizont
