#pragma once

#include <QByteArray>
#include <QString>

namespace gorizont::station {

/// What became of a file that a dispatcher sent (spec/mk14.md, Frames, 4).
struct ReceivedFile
{
    QString name; ///< as the station calls it, or as it came when it was refused; for the journal
    QString problem; ///< one sentence; empty: it is stored
};

/// Stores \a text under \a name in the \a folder of the station: only the files that a station reads (ACK.* and АСК.*, INPUT, METEO,
/// CORRECT and REAL with code and number), never one that names files of the computer (ACK.SRC), nothing with a path. The whole
/// file or nothing; what was there before is kept beside it as NAME.bak.
ReceivedFile storeReceivedFile(const QString &folder, const QByteArray &name, const QByteArray &text);

} // namespace gorizont::station
