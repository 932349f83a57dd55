#include "core/line/openline.h"

#include "core/line/serialline.h"
#include "core/line/tcpline.h"

#include <QUrl>

namespace gorizont {

QString deviceName(const LineConfig &config, const PortNaming &naming)
{
    if (!config.device.isEmpty()) {
        return config.device;
    }
    if (!naming.directory.isEmpty()) {
        return naming.directory + QStringLiteral("/COM%1").arg(config.com);
    }
#ifdef Q_OS_WIN
    return QStringLiteral("COM%1").arg(config.com);
#else
    return QStringLiteral("/dev/ttyS%1").arg(config.com - 1);
#endif
}

std::unique_ptr<Line> makeLine(const LineConfig &config, const PortNaming &naming, std::chrono::milliseconds pauseTick)
{
    const QString device = deviceName(config, naming);
    if (device.startsWith(QStringLiteral("tcp://"), Qt::CaseInsensitive)) {
        const QUrl url(device);
        return std::make_unique<TcpLine>(url.host(), static_cast<quint16>(url.port(0)), pauseTick);
    }
    if (device.startsWith(QStringLiteral("sim:"), Qt::CaseInsensitive)) {
        return nullptr;
    }
    return std::make_unique<SerialLine>(device, config, pauseTick);
}

} // namespace gorizont
