#pragma once

#include "core/values/sensortype.h"
#include "ui/models/health.h"

#include <QIcon>
#include <QSize>

namespace gorizont {

/// The icons of the window, drawn from resources/icons at every scale and kept. GUI thread.
namespace icons {

enum class Node : quint8 { Server, Port, Tilt, Acceleration, Usm, Vibration, Weather, None };

Node nodeOf(SensorType type);

QIcon state(Health health); ///< one shape and one colour for each state

QIcon information(); ///< of an event that is neither good nor bad

/// State and kind of a node side by side, treeSize() large: neither hides the other at 16 pixels.
QIcon tree(Node node, Health health);
QSize treeSize();

QIcon program();
QIcon tray(Health worst); ///< the program with the worst state in its corner

} // namespace icons

} // namespace gorizont
