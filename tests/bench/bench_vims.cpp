#include "core/devices/lvims/lvimsservice.h"
#include "core/devices/lvims/lvimssimulator.h"
#include "core/line/tcpline.h"
#include "core/simulation/simulatedtcpport.h"
#include "tests/core/devices/lvimsbench.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

#include <algorithm>
#include <cstdio>

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace gorizont;
using namespace std::chrono_literals;

/// Samples a second of a waveform of an L-VIMS over loopback, by the service and by a bare loop over a socket that sends the same
/// requests and looks at nothing.
namespace {

constexpr int rounds = 7;

double perSecond(qsizetype samples, qint64 nanoseconds)
{
    return static_cast<double>(samples) * 1e9 / static_cast<double>(nanoseconds);
}

/// 0: it failed.
double withService(Line &line, int *id)
{
    lvims::Capture capture = lvims::Service({}, {}).capture(lvims::Capture::Kind::Waveform, 0);
    while (capture.codes().isEmpty()) {
        QThread::msleep(static_cast<unsigned long>(capture.pause().count()));
        if (!capture.step(line, std::chrono::steady_clock::now())) {
            return 0;
        }
    }
    const qsizetype before = capture.codes().size();
    QElapsedTimer timer;
    timer.start();
    while (!capture.isDone()) {
        if (!capture.step(line, std::chrono::steady_clock::now())) {
            return 0;
        }
    }
    *id = capture.information().id;
    return perSecond(capture.codes().size() - before, timer.nsecsElapsed());
}

bool exactly(int socket, char *bytes, size_t size)
{
    for (size_t got = 0; got < size;) {
        const auto more = ::recv(socket, bytes + got, size - got, 0);
        if (more <= 0) {
            return false;
        }
        got += static_cast<size_t>(more);
    }
    return true;
}

/// Function 23: channel, ID and offset, then the echo and 60 samples.
double withBareSocket(quint16 port, int id)
{
    const int handle = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int on = 1;
    ::setsockopt(handle, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (::connect(handle, reinterpret_cast<const sockaddr *>(&address), sizeof address) != 0) {
        ::close(handle);
        return 0;
    }
    constexpr int samples = 102'360;
    constexpr size_t answerSize = 9 + 248;
    char answer[answerSize];
    bool isGood = true;
    QElapsedTimer timer;
    timer.start();
    for (int offset = 0; isGood && offset < samples; offset += 60) {
        const unsigned char request[] = {
            static_cast<unsigned char>(offset >> 8),
            static_cast<unsigned char>(offset),
            0,
            0,
            0,
            19,
            1,
            0x17,
            0x90,
            0,
            0,
            124,
            0x90,
            0,
            0,
            4,
            8,
            0,
            0,
            static_cast<unsigned char>(id >> 8),
            static_cast<unsigned char>(id),
            static_cast<unsigned char>(offset >> 8 & 0xFF),
            static_cast<unsigned char>(offset & 0xFF),
            0,
            static_cast<unsigned char>(offset >> 16)};
        isGood = ::send(handle, request, sizeof request, 0) == ssize_t(sizeof request)
            && exactly(handle, answer, answerSize) && answer[7] == 0x17;
    }
    const qint64 taken = timer.nsecsElapsed();
    ::close(handle);
    return isGood ? perSecond(samples, taken) : 0;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    LineConfig config;
    config.device = QStringLiteral("tcp://127.0.0.1:0");
    config.sensors = {test::vimsSensor()};
    auto *port = new SimulatedTcpPort(config, {1, {}, 0us});
    QThread thread;
    port->moveToThread(&thread);
    QObject::connect(&thread, &QThread::finished, port, &QObject::deleteLater);
    thread.start();
    quint16 number = 0;
    const auto plug = [&] {
        port->plug();
        number = port->port();
    };
    QMetaObject::invokeMethod(port, plug, Qt::BlockingQueuedConnection);
    TcpLine line(QStringLiteral("127.0.0.1"), number, 100ms);
    lvims::Service service({}, {});
    auto ready = line.open();
    if (ready) {
        QList<quint16> settings = service.settings(line, lvims::moduleRegister("CUR_SETTINGS"))->values();
        settings[lvims::settingRegister("WF_ACQ_TIME").address] = 4000;
        ready = service.restoreSettings(line, settings, false);
    }
    std::vector<double> ratios;
    for (int i = 0; ready && i < rounds; ++i) {
        int id = 0;
        const double ours = withService(line, &id);
        const double bare = withBareSocket(number, id);
        std::printf("service %.0f samples/s, bare socket %.0f samples/s\n", ours, bare);
        ratios.push_back(bare > 0 ? ours / bare : 0);
    }
    thread.quit();
    thread.wait();
    std::sort(ratios.begin(), ratios.end());
    const double median = ratios.empty() ? 0 : ratios[ratios.size() / 2];
    std::printf("median of the ratios %.2f\n", median);
    return ready ? 0 : 1;
}
