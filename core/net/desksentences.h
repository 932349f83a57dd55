#pragma once

#include "core/net/clientdiary.h"

#include <QAbstractSocket>
#include <QCoreApplication>
#include <QString>

namespace gorizont {

/// What a server tells the operator, each a sentence for the journal that names the service and says what to do where
/// something can be done. Pure.
class DeskSentences
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::DeskSentences)

public:
    /// \a service and \a portKey as in Service.
    DeskSentences(const QString &service, const QString &portKey);

    QString listening(quint16 port) const;
    QString stopped() const;
    QString cannotListen(
        int port, QAbstractSocket::SocketError error, const QString &reason, std::chrono::seconds retry) const;
    QString badBindAddress(const QString &text) const;
    QString badAllowEntry(const QString &text) const;
    QString cannotAccept(const QString &reason) const;
    QString acceptsAgain() const;
    QString came(const QHostAddress &address) const;
    QString gone(const QHostAddress &address, UtcTime left) const;
    QString cutOff(const QHostAddress &address, quint16 port) const;
    QString trouble(ClientTrouble trouble, const QHostAddress &address) const;

private:
    QString listenRemedy(QAbstractSocket::SocketError error) const;

    QString m_service;
    QString m_portKey;
};

} // namespace gorizont
