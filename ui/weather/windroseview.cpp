#include "ui/weather/windroseview.h"

#include "core/values/wind.h"
#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"

#include <algorithm>
#include <cmath>

namespace gorizont {

WindNow WindNow::of(const Weather &weather)
{
    WindNow now;
    if (const WeatherParameter *direction = weather.find(weathercode::windDirection)) {
        now.meanDirection = direction->mean;
        now.direction = direction->instant ? direction->instant : direction->mean;
    }
    if (const WeatherParameter *speed = weather.find(weathercode::windSpeed)) {
        now.meanSpeed = speed->mean;
        now.speed = speed->instant ? speed->instant : speed->mean;
    }
    now.gust = windOf(weather).maximum;
    return now;
}

WindRoseView::WindRoseView(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("windRose"));
    setAccessibleName(tr("Wind rose"));
    setMinimumSize(300, 240);
}

void WindRoseView::show(const WindCounts &counts, const WindNow &now, const QString &span)
{
    const bool isChanged = counts != m_counts || now != m_now;
    m_counts = counts;
    m_now = now;
    setAccessibleDescription(description(span));
    if (isChanged) {
        update();
    }
}

double WindRoseView::rimShare(double largest)
{
    static constexpr std::array steps{0.1, 0.2, 0.4, 0.6, 0.8};
    const auto *step = std::ranges::find_if(steps, [largest](double share) { return largest <= share; });
    return step == steps.end() ? 1 : *step;
}

QString WindRoseView::className(int speedClass)
{
    const auto at = static_cast<std::size_t>(speedClass);
    const auto bound = [](double speed) { return QString::number(speed); };
    if (speedClass + 1 == windrose::classCount) {
        return tr("from %1 m/s").arg(bound(windrose::classFloors[at]));
    }
    return tr("%1 – %2 m/s").arg(bound(windrose::classFloors[at]), bound(windrose::classFloors[at + 1]));
}

QString WindRoseView::description(const QString &span) const
{
    QStringList parts;
    parts += m_now.speed
        ? tr("Wind now: %1, %2 m/s.").arg(weathertext::direction(m_now.direction), valuetext::fixed(m_now.speed, 1))
        : tr("The wind is not known now.");
    if (m_counts.total() == 0) {
        parts += tr("No reading of the wind has come yet.");
        return parts.join(u' ');
    }
    QStringList rumbs;
    for (int sector = 0; sector < windrose::sectorCount; ++sector) {
        if (const quint32 count = m_counts.inSector(sector); count > 0) {
            rumbs += QStringLiteral("%1 %2 %").arg(
                weathertext::rumb(sector), valuetext::fixed(100 * m_counts.share(count), 0));
        }
    }
    rumbs += tr("calm %1 %").arg(valuetext::fixed(100 * m_counts.share(m_counts.calm), 0));
    parts += tr("Shares over %1: %2.").arg(span, rumbs.join(QStringLiteral(", ")));
    return parts.join(u' ');
}

} // namespace gorizont
