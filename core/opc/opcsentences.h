#pragma once

#include <QString>

namespace gorizont {

/// What the feed of OPC DA tells the operator beside what every server tells (DeskSentences). Pure.
namespace opcsentences {

/// Where there is no OPC DA, it says that too.
QString listening(quint16 port);
QString full(std::size_t gateways);
QString malformed();
QString stalled();
QString oldRegistration();

} // namespace opcsentences

} // namespace gorizont
