#include "core/mqtt/mqttconfig.h"

#include "core/mqtt/mqtttopics.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSysInfo>

namespace gorizont {

namespace {

QString defaultPrefix(const ServerConfig &config)
{
    const QString name = mqtttopic::level(config.name);
    return QStringLiteral("gorizont/") + (name.isEmpty() ? mqtttopic::level(QSysInfo::machineHostName()) : name);
}

/// 22 letters and digits: what every broker has to take (MQTT 3.1.1, section 3.1.3.1).
QString defaultClientId(const QString &dataFolder)
{
    const QByteArray own = (QSysInfo::machineHostName() + u'\n' + dataFolder).toUtf8();
    const QByteArray digits = QCryptographicHash::hash(own, QCryptographicHash::Sha256).toHex().first(14);
    return QStringLiteral("gorizont") + QString::fromLatin1(digits);
}

} // namespace

MqttConfig mqttConfig(const ServerConfig &config, const QString &dataFolder)
{
    constexpr qint64 mebibyte = 1024 * 1024;
    MqttConfig mqtt;
    mqtt.settings = config.mqtt;
    if (mqtt.settings.prefix.isEmpty()) {
        mqtt.settings.prefix = defaultPrefix(config);
    }
    if (mqtt.settings.clientId.isEmpty()) {
        mqtt.settings.clientId = defaultClientId(dataFolder);
    }
    mqtt.folder = QDir(dataFolder).filePath(QStringLiteral("Mqtt"));
    mqtt.lines = config.lines;
    mqtt.rules = {config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
    mqtt.queue = MessageQueue::Limits::of(config.mqtt.queueLimit * mebibyte);
    return mqtt;
}

} // namespace gorizont
