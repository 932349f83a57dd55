#pragma once

#include "core/files/recordfile.h"

#include <QHash>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <deque>
#include <map>

namespace gorizont::station {

/// One line for one of the station's text files.
struct StoredLine
{
    QString path; ///< below the folder of the data
    QByteArray heading; ///< with its line feed
    QByteArray record; ///< with its line feed
};

/// Writes the text files of a station. Lives in a thread of its own: a slow disk stops neither measuring nor answers. Every record
/// is one write; what a full disk does not take waits, the oldest is dropped when mostWaiting do. add() may be called
/// from any thread.
class StationStorage : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t mostWaiting = 4096;

    explicit StationStorage(const QString &folder, QObject *parent = nullptr);

    void add(const StoredLine &line);
    /// Writes a small file whole; \a path below the folder.
    void keep(const QString &path, const QByteArray &bytes);
    /// Tries to write what waits, once. To be called in its thread.
    void flush();
    /// What add() has queued and what waits, once more. To be called in its thread when it ends.
    void end();

Q_SIGNALS:
    /// Whether records are saved; \a text is a sentence for the journal. Once a change, and when a file had to be repaired.
    void told(bool isGood, const QString &text);

private:
    bool write(const StoredLine &line);
    void fail(const QString &why);

    QString m_folder;
    std::map<QString, RecordFile> m_files; ///< the last few, by path
    QHash<QString, QByteArray> m_headings; ///< the last of each file that is open, by path
    std::deque<StoredLine> m_waiting;
    std::atomic<std::size_t> m_posted{0}; ///< by add(), not taken yet: a disk that hangs in the system must not eat the memory
    QTimer m_retry{this};
    bool m_isBad = false;
};

} // namespace gorizont::station
