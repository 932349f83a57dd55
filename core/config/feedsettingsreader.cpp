#include "core/config/feedsettingsreader.h"

#include "core/config/sectionreader.h"

#include <QCoreApplication>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int tlsPort = 8883;
constexpr int mostQueueMiB = 1024 * 1024;

/// Certificates say nothing without TLS, and a certificate nothing without its key.
void settleTls(SectionReader &section, MqttSettings &mqtt)
{
    const QString notUsed = QCoreApplication::translate("ServerConfig", "It is not used.");
    const auto drop = [&](const QString &key, QString &value, const QString &problem) {
        if (!value.isEmpty()) {
            section.complain(key, problem, notUsed);
            section.replace(key);
            value.clear();
        }
    };
    if (!mqtt.usesTls) {
        const QString problem = QCoreApplication::translate("ServerConfig", "TLS=0 needs no certificates.");
        drop(u"CAFile"_s, mqtt.caFile, problem);
        drop(u"CertFile"_s, mqtt.certFile, problem);
        drop(u"KeyFile"_s, mqtt.keyFile, problem);
    } else if (mqtt.certFile.isEmpty() != mqtt.keyFile.isEmpty()) {
        const QString problem = QCoreApplication::translate(
            "ServerConfig", "CertFile and KeyFile belong together, one of them is missing.");
        drop(u"CertFile"_s, mqtt.certFile, problem);
        drop(u"KeyFile"_s, mqtt.keyFile, problem);
    }
}

void settlePassword(SectionReader &section, MqttSettings &mqtt)
{
    if (!mqtt.password.isEmpty() && !mqtt.passwordFile.isEmpty()) {
        section.complain(
            u"Password"_s, QCoreApplication::translate("ServerConfig", "PasswordFile gives the password already."),
            QCoreApplication::translate("ServerConfig", "It is not used."));
        section.replace(u"Password"_s);
        mqtt.password.clear();
    }
}

/// A topic that is published must not hold the wildcards of a subscription (MQTT 3.1.1, section 4.7.1).
void settlePrefix(SectionReader &section, MqttSettings &mqtt)
{
    if (mqtt.prefix.contains(u'#') || mqtt.prefix.contains(u'+')) {
        section.complain(
            u"Prefix"_s,
            QCoreApplication::translate("ServerConfig", "%1 has a # or a +, which topics must not have.")
                .arg(quoted(mqtt.prefix)),
            QCoreApplication::translate("ServerConfig", "The default is used."));
        section.replace(u"Prefix"_s);
        mqtt.prefix.clear();
    }
    while (mqtt.prefix.endsWith(u'/')) {
        mqtt.prefix.chop(1);
    }
}

} // namespace

MqttSettings readMqttSettings(const IniFile &file, Findings &findings)
{
    SectionReader section(file, u"MQTT"_s, findings);
    MqttSettings mqtt;
    section.take(u"Host"_s, mqtt.host);
    section.take(u"TLS"_s, mqtt.usesTls);
    mqtt.port = mqtt.usesTls ? tlsPort : mqtt.port;
    section.take(u"Port"_s, mqtt.port, {1, 65535});
    section.take(u"CAFile"_s, mqtt.caFile);
    section.take(u"CertFile"_s, mqtt.certFile);
    section.take(u"KeyFile"_s, mqtt.keyFile);
    section.take(u"User"_s, mqtt.user);
    section.take(u"PasswordFile"_s, mqtt.passwordFile);
    section.take(u"Password"_s, mqtt.password);
    section.take(u"ClientId"_s, mqtt.clientId);
    section.take(u"Prefix"_s, mqtt.prefix);
    section.take(u"QoS"_s, mqtt.qos, {0, 2});
    section.take(u"Interval"_s, mqtt.interval, {0});
    section.take(u"QueueLimit"_s, mqtt.queueLimit, {1, mostQueueMiB});
    settleTls(section, mqtt);
    settlePassword(section, mqtt);
    settlePrefix(section, mqtt);
    return mqtt;
}

MetricsSettings readMetricsSettings(const IniFile &file, Findings &findings)
{
    SectionReader section(file, u"Metrics"_s, findings);
    MetricsSettings metrics;
    section.take(u"Port"_s, metrics.port, {0, 65535});
    section.take(u"Bind"_s, metrics.bind);
    return metrics;
}

OpcSettings readOpcSettings(const IniFile &file, Findings &findings)
{
    SectionReader section(file, u"OPC"_s, findings);
    OpcSettings opc;
    section.take(u"Port"_s, opc.port, {1, 65535});
    return opc;
}

} // namespace gorizont
