#include "ui/plots/timeticker.h"

namespace gorizont {

namespace {

constexpr double minute = 60;
constexpr double hour = 60 * minute;
constexpr double day = 24 * hour;

QString formatOf(double span)
{
    if (span < 5) {
        return QStringLiteral("hh:mm:ss.zzz\ndd.MM.yy");
    }
    if (span < 10 * minute) {
        return QStringLiteral("hh:mm:ss\ndd.MM.yy");
    }
    if (span < 4 * day) {
        return QStringLiteral("hh:mm\ndd.MM.yy");
    }
    return span < 150 * day ? QStringLiteral("dd.MM\nyyyy") : QStringLiteral("MM\nyyyy");
}

} // namespace

/// Below a day, steps that the labels can tell apart: two and a half minutes are none.
double TimeTicker::getTickStep(const QCPRange &range)
{
    static const QVector<double> steps{1,      2,          5,          10,          15,          30,
                                       minute, 2 * minute, 5 * minute, 10 * minute, 15 * minute, 30 * minute,
                                       hour,   2 * hour,   3 * hour,   6 * hour,    12 * hour,   day};
    const double wanted = range.size() / tickCount();
    return wanted < 1 || wanted > day ? QCPAxisTickerDateTime::getTickStep(range) : pickClosest(wanted, steps);
}

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
