#include "ui/plots/trendlayouts.h"

#include <QSettings>
#include <QStringList>

namespace gorizont {

namespace {

constexpr qint64 longestSpan = qint64{40} * 366 * 86400;

/// `12:1 12:2`: sensor and number of the quantity.
QString curvesText(const QList<SeriesKey> &curves)
{
    QStringList parts;
    for (const SeriesKey &key : curves) {
        parts += QStringLiteral("%1:%2").arg(key.number).arg(static_cast<int>(key.quantity));
    }
    return parts.join(u' ');
}

QList<SeriesKey> curvesOf(const QString &text)
{
    QList<SeriesKey> keys;
    for (const QString &part : text.split(u' ', Qt::SkipEmptyParts)) {
        bool hasNumber = false;
        bool hasQuantity = false;
        const int number = part.section(u':', 0, 0).toInt(&hasNumber);
        const int quantity = part.section(u':', 1).toInt(&hasQuantity);
        const bool isKnown = quantity >= int(Quantity::TiltX) && quantity <= int(Quantity::Humidity);
        if (hasNumber && hasQuantity && isKnown) {
            keys.append({number, static_cast<Quantity>(quantity)});
        }
    }
    return keys;
}

} // namespace

QList<TrendLayout> readTrendLayouts(QSettings &settings, const QString &group)
{
    QList<TrendLayout> layouts;
    const int count = settings.beginReadArray(group);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        TrendLayout layout;
        layout.name = settings.value(QStringLiteral("name")).toString();
        layout.curves = curvesOf(settings.value(QStringLiteral("curves")).toString());
        const qint64 seconds = settings.value(QStringLiteral("seconds")).toLongLong();
        if (seconds > 0 && seconds <= longestSpan) {
            layout.span = std::chrono::seconds(seconds);
        }
        layout.unit = settings.value(QStringLiteral("arcSeconds")).toBool() ? TiltUnit::ArcSeconds : TiltUnit::Degrees;
        layouts.append(layout);
    }
    settings.endArray();
    return layouts;
}

void writeTrendLayouts(QSettings &settings, const QString &group, const QList<TrendLayout> &layouts)
{
    settings.remove(group);
    settings.beginWriteArray(group, static_cast<int>(layouts.size()));
    for (qsizetype i = 0; i < layouts.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue(QStringLiteral("name"), layouts.at(i).name);
        settings.setValue(QStringLiteral("curves"), curvesText(layouts.at(i).curves));
        settings.setValue(QStringLiteral("seconds"), qint64(layouts.at(i).span.count()));
        settings.setValue(QStringLiteral("arcSeconds"), layouts.at(i).unit == TiltUnit::ArcSeconds);
    }
    settings.endArray();
}

} // namespace gorizont
