#pragma once

#include "core/metrics/sitemetrics.h"

#include <QMap>
#include <QMutex>

namespace gorizont {

/// The last of everything that is counted, for whoever asks. Thread-safe: whoever asks gets a copy, and the lock is held
/// for the copying only.
class MetricsBoard
{
public:
    explicit MetricsBoard(const QList<LineConfig> &lines);

    void put(const Readings &batch);
    void put(const LineStatus &status);
    /// What another part of the program counts, in place of what \a source put before.
    void put(const QString &source, const MetricFamilies &families);

    /// Everything as it is at \a now.
    MetricFamilies families(SteadyTime now) const;

private:
    mutable QMutex m_mutex;
    SiteSnapshot m_site;
    QMap<QString, MetricFamilies> m_others;
};

} // namespace gorizont
