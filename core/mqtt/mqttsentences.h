#pragma once

#include "core/config/feedsettings.h"
#include "core/mqtt/brokersession.h"

/// What the publisher tells the operator, each a sentence for the journal that says what to do where something can be
/// done. Pure.
namespace gorizont::mqttsentence {

/// \a waiting: readings that came while the broker was away.
QString connected(const MqttSettings &settings, quint64 waiting);
QString trouble(BrokerTrouble trouble, const MqttSettings &settings, const QString &detail);
/// Lost in memory: the thread of the publisher was held up for too long.
QString heldUp(quint64 lost);

} // namespace gorizont::mqttsentence
