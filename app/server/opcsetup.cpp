#include "app/server/opcsetup.h"

#include "app/server/gatewayregistration.h"
#include "core/opc/opclines.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>

#include <utility>

namespace gorizont {

OpcSetup::OpcSetup(const QString &folder, const QList<OpcTag> &tags, QObject *parent)
    : QObject(parent)
    , m_folder(QDir(folder).filePath(QStringLiteral("OPC")))
    , m_tags(tags)
{
}

QString OpcSetup::file(const char *name) const
{
    return QDir(m_folder).filePath(QLatin1String(name));
}

QString OpcSetup::listFile() const
{
    return file("tags.txt");
}

/// What the file `registered` holds once all is done.
QByteArray OpcSetup::mark(int port) const
{
    return opcTagsHash(m_tags) + ' ' + QByteArray::number(port) + '\n';
}

void OpcSetup::run(int port)
{
    QFile registered(file("registered"));
    if (registered.open(QIODevice::ReadOnly) && registered.readAll() == mark(port)) {
        return;
    }
    m_told.clear();
    if (!writeFiles()) {
        Q_EMIT done(m_told.join(u'\n'));
        return;
    }
    const auto finished = [this, port](const QString &problem) { finish(port, problem); };
    registerGateway(registrationArguments(port, opcTagsHash(m_tags), file("tags.jsonl")), this, finished);
}

void OpcSetup::renew(int port)
{
    if (canRegisterGateways() && !std::exchange(m_hasRenewed, true)) {
        QFile::remove(file("registered"));
        run(port);
    }
}

bool OpcSetup::writeFiles()
{
    QDir().mkpath(m_folder);
    if (!write(listFile(), opcTagList(m_tags)) || !write(file("tags.jsonl"), opclines::tagLines(m_tags).join())) {
        return false;
    }
    tell(
        JournalKind::Info,
        tr("OPC DA: the list of tags is new (tags: %1). It was written to %2.")
            .arg(m_tags.size())
            .arg(QDir::toNativeSeparators(listFile())));
    return true;
}

void OpcSetup::finish(int port, const QString &problem)
{
    if (!problem.isEmpty()) {
        tell(JournalKind::Error, tr("OPC DA: the gateway could not be registered. %1").arg(problem));
    } else {
        if (canRegisterGateways()) {
            tell(
                JournalKind::On,
                tr("OPC DA: the server OPC.DA.GorizontServer was registered. Later runs need no administrator."));
        }
        write(file("registered"), mark(port));
    }
    Q_EMIT done(m_told.join(u'\n'));
}

bool OpcSetup::write(const QString &path, const QByteArray &bytes)
{
    QSaveFile target(path);
    if (target.open(QIODevice::WriteOnly) && target.write(bytes) == bytes.size() && target.commit()) {
        return true;
    }
    tell(
        JournalKind::Error,
        tr("OPC DA: %1 cannot be written (%2). Check the rights of the folder and the room on the disk.")
            .arg(QDir::toNativeSeparators(path), target.errorString()));
    return false;
}

void OpcSetup::tell(JournalKind kind, const QString &text)
{
    m_told.append(text);
    Q_EMIT journal({kind, utcNow(), text});
}

} // namespace gorizont
