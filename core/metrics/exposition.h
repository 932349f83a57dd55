#pragma once

#include <QByteArray>
#include <QList>
#include <QPair>
#include <QString>

namespace gorizont {

/// One number of a family.
struct MetricSample
{
    QList<QPair<QByteArray, QString>> labels; ///< name → any text
    double value = 0;

    bool operator==(const MetricSample &) const = default;
};

/// What belongs together under one name.
struct MetricFamily
{
    enum class Type : quint8 { Counter, Gauge };

    QByteArray name; ///< `gorizont_…`, with its unit; of a counter with `_total`
    Type type = Type::Gauge;
    QString help; ///< one sentence
    QList<MetricSample> samples;

    bool operator==(const MetricFamily &) const = default;
};

using MetricFamilies = QList<MetricFamily>;

/// The text format that Prometheus reads, version 0.0.4
/// (https://prometheus.io/docs/instrumenting/exposition_formats/). A family without samples is left out. Pure.
///
///     # HELP gorizont_sensor_answers_total Good answers of the sensor.
///     # TYPE gorizont_sensor_answers_total counter
///     gorizont_sensor_answers_total{port="COM4",sensor="1"} 17
QByteArray expositionText(const MetricFamilies &families);

} // namespace gorizont
