#include "app/server/singleinstance.h"

#include <QCryptographicHash>
#include <QDir>
#include <QLocalSocket>

namespace gorizont {

namespace {

constexpr int answerLimit = 2000; ///< ms

} // namespace

SingleInstance::SingleInstance(const QString &dataFolder, QObject *parent)
    : QObject(parent)
    , m_folder(QFileInfo(dataFolder).canonicalFilePath())
{
}

SingleInstance::~SingleInstance() = default;

QString SingleInstance::serverName() const
{
    const QByteArray hash = QCryptographicHash::hash(m_folder.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStringLiteral("gorizont-server-") + QString::fromLatin1(hash.left(16));
}

/// A lock that was made by another user could not be taken over after a crash, so each has one.
bool SingleInstance::acquireOpc(int port)
{
    const QString name = QStringLiteral("gorizont-server-opc-%1-%2.lock").arg(QDir::home().dirName()).arg(port);
    m_opcLock = std::make_unique<QLockFile>(QDir(QDir::tempPath()).filePath(name));
    m_opcLock->setStaleLockTime(0);
    return m_opcLock->tryLock() || m_opcLock->error() != QLockFile::LockFailedError;
}

bool SingleInstance::acquire()
{
    m_lock = std::make_unique<QLockFile>(QDir(m_folder).filePath(QStringLiteral("gorizont-server.lock")));
    m_lock->setStaleLockTime(0); // a copy may run for months; only a dead process makes a lock stale
    if (!m_lock->tryLock()) {
        return m_lock->error() != QLockFile::LockFailedError;
    }
    m_server = std::make_unique<QLocalServer>();
    m_server->setSocketOptions(QLocalServer::UserAccessOption);
    QLocalServer::removeServer(serverName());
    m_server->listen(serverName());
    connect(m_server.get(), &QLocalServer::newConnection, this, [this] {
        while (QLocalSocket *socket = m_server->nextPendingConnection()) {
            socket->write("+");
            socket->flush();
            connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
            socket->disconnectFromServer();
        }
        Q_EMIT raiseRequested();
    });
    return true;
}

bool SingleInstance::raiseOther() const
{
    QLocalSocket socket;
    socket.connectToServer(serverName());
    return socket.waitForConnected(answerLimit) && socket.waitForReadyRead(answerLimit);
}

} // namespace gorizont
