#pragma once

#include "core/modbus/clientdiary.h"

#include <QAbstractSocket>
#include <QString>

namespace gorizont::modbussentence {

/// What the Modbus TCP server tells the operator, each a sentence for the journal that says what to do where something
/// can be done. Pure.
QString listening(quint16 port);
QString stopped();
QString cannotListen(int port, QAbstractSocket::SocketError error, const QString &reason, std::chrono::seconds retry);
QString badBindAddress(const QString &text);
QString badAllowEntry(const QString &text);
QString unreachableSensors(const QList<int> &numbers);
QString cannotAccept(const QString &reason);
QString acceptsAgain();
QString came(const QHostAddress &address);
QString gone(const QHostAddress &address, UtcTime left);
QString trouble(ClientTrouble trouble, const QHostAddress &address);

} // namespace gorizont::modbussentence
