#pragma once

#include "core/history/historyconfig.h"
#include "core/values/captureplan.h"
#include "core/values/journalentry.h"

#include <QCoreApplication>
#include <QHash>

#include <functional>

namespace gorizont {

/// `18_02_07_18_33_03_5_ch0.csv`: time when the capture was whole, N, channel; of a spectrum `…_ch0_5000.csv` or `…_ch0_200.csv`.
QString captureFileName(const QDateTime &local, const SignalCapture &captured, const QString &suffix);

/// The files of continuous captures, `History/Vims`: each is there whole or not at all. A disk that takes no more loses the capture,
/// which is told once until one can be saved again. Storage thread.
class CaptureFolder
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::CaptureFolder)

public:
    using Note = std::function<void(JournalKind, const QString &)>;

    CaptureFolder(const HistoryConfig &config, Note note);

    /// A sensor of the site captures.
    bool isInUse() const { return !m_plans.isEmpty(); }

    /// Removes what a run that was killed has left half-written.
    void open();
    /// In the formats that the ini asks for; captures of other sensors are ignored.
    void save(const SignalCapture &captured);
    /// Removes the captures whose time by their name is longer ago than CaptureKeep.
    void removeOld(UtcTime now);

private:
    QString write(const SignalCapture &captured, const QString &suffix, const QByteArray &bytes) const;
    void noteOutcome(const QString &problem);

    const QString m_folder;
    const QTimeZone m_zone;
    const Note m_note;
    QHash<int, CapturePlan> m_plans; ///< by N, of those that capture
    bool m_isFailing = false;
};

} // namespace gorizont
