#pragma once

#include <QLocalServer>
#include <QLockFile>
#include <QObject>

#include <memory>

namespace gorizont {

/// One copy of the program for one data folder: two would write into the same files. The first copy holds a lock file in
/// the folder and listens; the next one finds it and asks it to show its window.
class SingleInstance : public QObject
{
    Q_OBJECT

public:
    explicit SingleInstance(const QString &dataFolder, QObject *parent = nullptr);
    ~SingleInstance() override;

    /// True: this is the first copy (or the folder cannot hold a lock, which the files will complain about).
    bool acquire();

    /// With OPC DA one copy of the program works on a computer, whatever its folder (manual 000, 11.3). \a port: of the feed. False:
    /// another copy of this user has it.
    bool acquireOpc(int port);

    /// Asks the copy that holds the folder to show its window. False: it did not answer.
    bool raiseOther() const;

Q_SIGNALS:
    /// Another copy was started and has ended in favour of this one.
    void raiseRequested();

private:
    QString serverName() const;

    QString m_folder;
    std::unique_ptr<QLockFile> m_lock;
    std::unique_ptr<QLockFile> m_opcLock;
    std::unique_ptr<QLocalServer> m_server;
};

} // namespace gorizont
