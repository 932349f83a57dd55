#include "core/metrics/metricsboard.h"

#include <QMutexLocker>

namespace gorizont {

MetricsBoard::MetricsBoard(const QList<LineConfig> &lines)
{
    m_site.lines = lines;
    m_site.started = SteadyTime::clock::now();
}

void MetricsBoard::put(const Readings &batch)
{
    const QMutexLocker lock(&m_mutex);
    for (const Reading &reading : batch) {
        m_site.readings.insert(reading.number, reading);
    }
}

void MetricsBoard::put(const LineStatus &status)
{
    const QMutexLocker lock(&m_mutex);
    m_site.statuses.insert(status.port, status);
}

void MetricsBoard::put(const QString &source, const MetricFamilies &families)
{
    const QMutexLocker lock(&m_mutex);
    m_others.insert(source, families);
}

MetricFamilies MetricsBoard::families(SteadyTime now) const
{
    QMutexLocker lock(&m_mutex);
    SiteSnapshot site = m_site;
    const QMap<QString, MetricFamilies> others = m_others;
    lock.unlock();
    site.now = now;
    MetricFamilies all = siteMetrics(site);
    for (const MetricFamilies &families : others) {
        all += families;
    }
    return all;
}

} // namespace gorizont
