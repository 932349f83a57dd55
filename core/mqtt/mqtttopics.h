#pragma once

#include <QByteArray>
#include <QString>

/// The topics below the prefix. Pure.
///
///     <prefix>/status            retained, `online` or `offline`; the last will
///     <prefix>/sensor/3/reading  each reading
///     <prefix>/sensor/3/state    retained
///     <prefix>/port/1/state      retained; 1: of [Port1]
namespace gorizont::mqtttopic {

QByteArray status();
QByteArray sensorReading(int number);
QByteArray sensorState(int number);
QByteArray portState(int port);

/// \a prefix and \a topic as one.
QByteArray under(const QString &prefix, const QByteArray &topic);

/// \a name as one level of a topic: what separates levels, stands for levels or cannot be seen becomes `_`.
QString level(const QString &name);

} // namespace gorizont::mqtttopic
