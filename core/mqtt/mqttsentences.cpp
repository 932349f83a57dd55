#include "core/mqtt/mqttsentences.h"

#include <QCoreApplication>

namespace gorizont::mqttsentence {

namespace {

QString brokerOf(const MqttSettings &settings)
{
    const bool isV6 = settings.host.contains(u':');
    return QStringLiteral("%1:%2").arg(isV6 ? u'[' + settings.host + u']' : settings.host).arg(settings.port);
}

QString reason(BrokerTrouble trouble, const MqttSettings &settings, const QString &detail)
{
    const QString broker = brokerOf(settings);
    switch (trouble) {
    case BrokerTrouble::UnknownHost:
        return QCoreApplication::translate(
                   "Mqtt", "MQTT: no address is known for %1 (%2). Check Host in [MQTT] and the name server.")
            .arg(settings.host, detail);
    case BrokerTrouble::Unreachable:
        return QCoreApplication::translate(
                   "Mqtt",
                   "MQTT: the broker %1 cannot be reached (%2). Check Host, Port and TLS in [MQTT], and the network.")
            .arg(broker, detail);
    case BrokerTrouble::NoAnswer:
        return QCoreApplication::translate(
                   "Mqtt", "MQTT: the broker %1 does not answer. Check Host, Port and TLS in [MQTT], and the network.")
            .arg(broker);
    case BrokerTrouble::UnreadableFile:
        return QCoreApplication::translate(
                   "Mqtt", "MQTT: a file named in [MQTT] cannot be read: %1. Check its name and its rights.")
            .arg(detail);
    case BrokerTrouble::TlsFailed:
        return QCoreApplication::translate(
                   "Mqtt",
                   "MQTT: no encrypted connection to the broker %1 (%2). Check Port and the certificates in [MQTT].")
            .arg(broker, detail);
    case BrokerTrouble::NotTrusted:
        return QCoreApplication::translate(
                   "Mqtt",
                   "MQTT: the certificate of the broker %1 is not trusted (%2). CAFile in [MQTT] has to hold who "
                   "signed "
                   "it, Host the name it is for.")
            .arg(broker, detail);
    case BrokerTrouble::WrongPassword:
        return QCoreApplication::translate(
                   "Mqtt",
                   "MQTT: the broker %1 does not accept user and password. Check User and PasswordFile in [MQTT].")
            .arg(broker);
    case BrokerTrouble::NotAuthorized:
        return QCoreApplication::translate(
                   "Mqtt",
                   "MQTT: the broker %1 lets nobody in as this user. Check User and PasswordFile in [MQTT], and the "
                   "rights given in the broker.")
            .arg(broker);
    case BrokerTrouble::Rejected:
        return QCoreApplication::translate("Mqtt", "MQTT: the broker %1 rejects the connection (%2).")
            .arg(broker, detail);
    case BrokerTrouble::Lost:
        return QCoreApplication::translate("Mqtt", "MQTT: the connection to the broker %1 is lost (%2).")
            .arg(broker, detail);
    }
    return {};
}

} // namespace

QString connected(const MqttSettings &settings, quint64 waiting)
{
    const QString sentence =
        QCoreApplication::translate("Mqtt", "MQTT: connected to the broker %1.").arg(brokerOf(settings));
    if (waiting == 0) {
        return sentence;
    }
    return sentence + u' '
        + QCoreApplication::translate("Mqtt", "Readings that wait and are sent first: %1.").arg(waiting);
}

QString trouble(BrokerTrouble trouble, const MqttSettings &settings, const QString &detail)
{
    return reason(trouble, settings, detail) + u' '
        + QCoreApplication::translate("Mqtt", "Readings are kept on the disk until they can be sent.");
}

QString heldUp(quint64 lost)
{
    return QCoreApplication::translate(
               "Mqtt", "MQTT: disk or name server were busy for too long, readings that were not kept: %1.")
        .arg(lost);
}

} // namespace gorizont::mqttsentence
