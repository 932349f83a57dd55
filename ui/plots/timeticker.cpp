#include "ui/plots/timeticker.h"

namespace gorizont {

namespace {

constexpr double minute = 60;
constexpr double day = 86400;

QString formatOf(double span)
{
    if (span < 10 * minute) {
        return QStringLiteral("hh:mm:ss\ndd.MM.yy");
    }
    if (span < 4 * day) {
        return QStringLiteral("hh:mm\ndd.MM.yy");
    }
    return span < 150 * day ? QStringLiteral("dd.MM\nyyyy") : QStringLiteral("MM\nyyyy");
}

} // namespace

void TimeTicker::generate(
    const QCPRange &range, const QLocale &locale, QChar formatChar, int precision, QVector<double> &ticks,
    QVector<double> *subTicks, QVector<QString> *tickLabels)
{
    setDateTimeFormat(formatOf(range.size()));
    // Ticks of hours are counted from a local midnight.
    setTickOrigin(QDateTime(keyToDateTime(range.lower).date(), QTime(0, 0)));
    QCPAxisTickerDateTime::generate(range, locale, formatChar, precision, ticks, subTicks, tickLabels);
}

} // namespace gorizont
