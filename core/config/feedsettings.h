#pragma once

#include <QString>

#include <chrono>

namespace gorizont {

/// [MQTT] of the ini: the broker that gets the readings. Host decides whether there is one.
struct MqttSettings
{
    QString host; ///< Host: name or address of the broker; empty: nothing is sent
    int port = 1883; ///< Port; absent: 1883, with TLS 8883
    bool usesTls = false; ///< TLS
    QString caFile; ///< CAFile: PEM of who signed the broker's certificate; empty: those the system trusts
    QString certFile; ///< CertFile: PEM of our own certificate; empty: none
    QString keyFile; ///< KeyFile: PEM of its key
    QString user; ///< User; empty: nobody in particular
    QString passwordFile; ///< PasswordFile: its first line is the password; wins over Password
    QString password; ///< Password
    QString clientId; ///< ClientId; empty: made of the computer and the data folder
    QString prefix; ///< Prefix of all topics; empty: `gorizont/` and the name of this copy or of the computer
    int qos = 1; ///< QoS: 0…2
    std::chrono::milliseconds interval{0}; ///< Interval: least time between two readings of one sensor; 0: all
    int queueLimit = 64; ///< QueueLimit: MiB on the disk while the broker is away

    bool isOn() const { return !host.isEmpty(); }
    bool operator==(const MqttSettings &) const = default;
};

/// [Metrics] of the ini: counters for Prometheus.
struct MetricsSettings
{
    int port = 0; ///< Port; 0: not served
    QString bind = QStringLiteral("127.0.0.1"); ///< Bind: address to listen on

    bool isOn() const { return port != 0; }
    bool operator==(const MetricsSettings &) const = default;
};

/// [OPC] of the ini: where gateways of OPC DA get the tags, on this computer only. CanOPCDA decides whether they do.
struct OpcSettings
{
    int port = 43212; ///< Port

    bool operator==(const OpcSettings &) const = default;
};

} // namespace gorizont
