#include "core/station/sources/pulsesource.h"

#include <QCoreApplication>
#include <QFile>

#ifdef Q_OS_LINUX
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace gorizont::station {

namespace {

#ifdef Q_OS_LINUX

/// A signal ends an ioctl that waits; what it does then is nothing.
extern "C" void onWake(int) {}

constexpr int wakeSignal = SIGUSR2;

void installWakeSignal()
{
    struct sigaction action = {};
    action.sa_handler = onWake; // without SA_RESTART: the wait must end
    sigaction(wakeSignal, &action, nullptr);
}

class LinuxModemPort : public ModemPort
{
public:
    explicit LinuxModemPort(const QString &device)
        : m_device(device)
    {
    }
    ~LinuxModemPort() override { close(); }

    QString name() const override { return m_device; }

    QString open() override
    {
        close();
        m_port = ::open(QFile::encodeName(m_device).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        int lines = 0;
        if (m_port < 0 || ::ioctl(m_port, TIOCMGET, &lines) != 0) {
            const QString why = qt_error_string(errno);
            close();
            return why;
        }
        installWakeSignal();
        return {};
    }

    void close() override
    {
        if (m_port >= 0) {
            ::close(m_port);
            m_port = -1;
        }
    }

    std::optional<ModemLines> waitForChange() override
    {
        int lines = 0;
        if (::ioctl(m_port, TIOCMIWAIT, TIOCM_CTS | TIOCM_DSR) != 0 || ::ioctl(m_port, TIOCMGET, &lines) != 0) {
            return std::nullopt;
        }
        return ModemLines{(lines & TIOCM_CTS) != 0, (lines & TIOCM_DSR) != 0};
    }

    void interrupt(std::thread &waiting) override { ::pthread_kill(waiting.native_handle(), wakeSignal); }

private:
    QString m_device;
    int m_port = -1;
};

#else

class NoModemPort : public ModemPort
{
public:
    explicit NoModemPort(const QString &device)
        : m_device(device)
    {
    }
    QString name() const override { return m_device; }
    QString open() override
    {
        return QCoreApplication::translate("gorizont::ModemPort", "pulses of the wind can be counted on Linux only");
    }
    void close() override {}
    std::optional<ModemLines> waitForChange() override { return std::nullopt; }
    void interrupt(std::thread &) override {}

private:
    QString m_device;
};

#endif

} // namespace

std::unique_ptr<ModemPort> makeModemPort(const QString &device)
{
#ifdef Q_OS_LINUX
    return std::make_unique<LinuxModemPort>(device);
#else
    return std::make_unique<NoModemPort>(device);
#endif
}

} // namespace gorizont::station
