#pragma once

#include "core/values/series.h"
#include "ui/plots/plottext.h"

class QSettings;

namespace gorizont {

/// What the page of trends shows: kept under a name, to be found again.
struct TrendLayout
{
    QString name;
    QList<SeriesKey> curves;
    std::chrono::seconds span{3600};
    TiltUnit unit = TiltUnit::Degrees;
    bool operator==(const TrendLayout &) const = default;
};

/// Kept beside the layout of the window. What is damaged is left out.
QList<TrendLayout> readTrendLayouts(QSettings &settings, const QString &group);
void writeTrendLayouts(QSettings &settings, const QString &group, const QList<TrendLayout> &layouts);

} // namespace gorizont
