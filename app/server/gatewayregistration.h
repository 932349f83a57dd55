#pragma once

#include <QObject>
#include <QStringList>

#include <functional>

namespace gorizont {

/// What the gateway gorizont-opc-da is told when it enters itself into the registry of Windows: where the feed is, and which list
/// of tags was current then.
QStringList registrationArguments(int port, const QByteArray &hash, const QString &tagsFile);

/// Whether gateways can be registered on this system at all.
bool canRegisterGateways();

/// Starts the gateway that lies beside the program to register itself, and returns at once. \a done gets a sentence that says what
/// went wrong; empty: nothing. It is called unless \a context is gone by then.
void registerGateway(const QStringList &arguments, QObject *context, const std::function<void(QString)> &done);

} // namespace gorizont
