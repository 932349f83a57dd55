#include "ui/history/daymark.h"

#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

namespace {

constexpr qsizetype mostLines = 8; ///< of sensors in a tool tip

struct Calendar
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::DayCalendar)
};

QString titleOf(int number, const QList<SensorConfig> &sensors)
{
    const auto found = std::find_if(sensors.begin(), sensors.end(), [number](const SensorConfig &sensor) {
        return sensor.number == number;
    });
    return found == sensors.end() ? QString::number(number) : statetext::sensorTitle(*found);
}

QString sharesText(QDate day, QList<DayCompleteness> sensors, const QList<SensorConfig> &configs, const DayMark &mark)
{
    QStringList lines{
        calendarLocale().toString(day, QLocale::LongFormat),
        mark.valid >= mark.length ? Calendar::tr("nothing is missing")
                                  : Calendar::tr("%1 % are there").arg(percentText(mark))};
    std::stable_sort(sensors.begin(), sensors.end(), [](const DayCompleteness &a, const DayCompleteness &b) {
        return a.share() < b.share();
    });
    qsizetype left = 0;
    for (const DayCompleteness &one : sensors) {
        if (one.valid >= one.length) {
            continue;
        }
        if (lines.size() >= mostLines + 2) {
            ++left;
            continue;
        }
        lines << Calendar::tr("%1: %2 missing")
                     .arg(titleOf(one.number, configs), valuetext::duration(one.length - one.valid));
    }
    if (left > 0) {
        lines << Calendar::tr("and %n more sensor(s)", nullptr, static_cast<int>(left));
    }
    return lines.join(u'\n');
}

} // namespace

DayMarks dayMarks(const QList<DayCompleteness> &days, const QList<SensorConfig> &sensors)
{
    QHash<QDate, QList<DayCompleteness>> byDay;
    for (const DayCompleteness &one : days) {
        byDay[one.day] << one;
    }
    DayMarks marks;
    for (auto day = byDay.cbegin(); day != byDay.cend(); ++day) {
        DayMark mark;
        for (const DayCompleteness &one : day.value()) {
            mark.valid += std::min(one.valid, one.length);
            mark.length += one.length;
        }
        mark.toolTip = sharesText(day.key(), day.value(), sensors, mark);
        marks.insert(day.key(), mark);
    }
    return marks;
}

QLocale calendarLocale()
{
    //: the locale of this language, as in ru_RU
    return QLocale(Calendar::tr("en_GB"));
}

QString percentText(const DayMark &mark)
{
    const auto percent = static_cast<int>(mark.share() * 100);
    return percent == 0 && mark.valid.count() > 0 ? QStringLiteral("<1") : QString::number(percent);
}

QColor dayColour(const DayMark &mark, bool isDark)
{
    if (!mark.isKnown()) {
        return {};
    }
    if (mark.valid >= mark.length) {
        return isDark ? QColor(0x1e, 0x5c, 0x33) : QColor(0xb7, 0xe4, 0xc4);
    }
    if (mark.share() >= 0.9) {
        return isDark ? QColor(0x55, 0x63, 0x1c) : QColor(0xe3, 0xee, 0xb0);
    }
    if (mark.share() >= 0.5) {
        return isDark ? QColor(0x7a, 0x50, 0x10) : QColor(0xfd, 0xdd, 0xa6);
    }
    return isDark ? QColor(0x7d, 0x2a, 0x2a) : QColor(0xf7, 0xc0, 0xbd);
}

} // namespace gorizont
