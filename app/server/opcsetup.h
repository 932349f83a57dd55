#pragma once

#include "core/opc/opctags.h"
#include "core/values/journalentry.h"

#include <QObject>

namespace gorizont {

/// The first run with a new list of tags, or another port (manual 000, 11.5): writes the list for people and for the gateway, has
/// the gateway registered where there is Windows, and says what was done. Later runs find that it was done. Main thread.
class OpcSetup : public QObject
{
    Q_OBJECT

public:
    /// \a folder: of the data; the files go into OPC below it.
    OpcSetup(const QString &folder, const QList<OpcTag> &tags, QObject *parent = nullptr);

    /// Does nothing when it was done for this list and this port before.
    void run(int port);
    /// A gateway said that it was registered with another list, or with none, such as after its installer: where there is Windows,
    /// it is registered again, once in a run of the program.
    void renew(int port);

    QString listFile() const; ///< name, type and description, for people

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);
    /// The same in one text, for a window.
    void done(const QString &message);

private:
    bool writeFiles();
    void finish(int port, const QString &problem);
    QString file(const char *name) const;
    QByteArray mark(int port) const;
    bool write(const QString &path, const QByteArray &bytes);
    void tell(JournalKind kind, const QString &text);

    const QString m_folder;
    const QList<OpcTag> m_tags;
    QStringList m_told; ///< by the last run()
    bool m_hasRenewed = false;
};

} // namespace gorizont
