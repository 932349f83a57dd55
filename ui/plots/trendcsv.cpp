#include "ui/plots/trendcsv.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>

#include <algorithm>

namespace gorizont {

namespace {

struct CsvText
{
    Q_DECLARE_TR_FUNCTIONS(CsvText)
};

QString quoted(QString field, QChar separator)
{
    const bool isPlain = !field.contains(separator) && !field.contains(u'"') && !field.contains(u'\n');
    return isPlain ? field : u'"' + field.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString number(double value, CsvForm form)
{
    QString text = QString::number(value, 'g', 10);
    return form == CsvForm::RussianExcel ? text.replace(u'.', u',') : text;
}

QString moment(UtcTime time, CsvForm form, const QTimeZone &zone)
{
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(milliseconds, zone);
    if (form == CsvForm::RussianExcel) {
        return local.toString(QStringLiteral("dd.MM.yyyy hh:mm:ss,zzz"));
    }
    return local.toOffsetFromUtc(local.offsetFromUtc()).toString(Qt::ISODateWithMs);
}

bool hasBand(const CsvCurve &curve)
{
    return curve.series.step.count() > 0;
}

QStringList heading(const QList<CsvCurve> &curves)
{
    QStringList fields{CsvText::tr("Time")};
    for (const CsvCurve &curve : curves) {
        const QString title = QStringLiteral("%1, %2").arg(curve.title, curve.unit);
        fields += title;
        if (hasBand(curve)) {
            fields += CsvText::tr("%1, min.").arg(title);
            fields += CsvText::tr("%1, max.").arg(title);
        }
    }
    return fields;
}

QList<UtcTime> moments(const QList<CsvCurve> &curves, const TimeSpan &span)
{
    QList<UtcTime> times;
    for (const CsvCurve &curve : curves) {
        for (const SeriesBucket &bucket : curve.series.buckets) {
            if (bucket.from >= span.from && bucket.from < span.to) {
                times.append(bucket.from);
            }
        }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

} // namespace

QByteArray trendCsv(const QList<CsvCurve> &curves, const TimeSpan &span, CsvForm form, const QTimeZone &zone)
{
    const QChar separator = form == CsvForm::RussianExcel ? u';' : u',';
    QByteArray table = form == CsvForm::RussianExcel ? QByteArray("\xEF\xBB\xBF") : QByteArray();
    const auto write = [&table, separator](QStringList fields) {
        for (QString &field : fields) {
            field = quoted(field, separator);
        }
        table += fields.join(separator).toUtf8() + "\r\n";
    };
    write(heading(curves));
    QList<qsizetype> next(curves.size(), 0);
    for (const UtcTime time : moments(curves, span)) {
        QStringList fields{moment(time, form, zone)};
        for (qsizetype i = 0; i < curves.size(); ++i) {
            const CsvCurve &curve = curves.at(i);
            const QList<SeriesBucket> &buckets = curve.series.buckets;
            while (next.at(i) < buckets.size() && buckets.at(next.at(i)).from < time) {
                ++next[i];
            }
            const SeriesBucket bucket = buckets.value(next.at(i));
            const bool isThere = next.at(i) < buckets.size() && bucket.from == time && bucket.valid > 0;
            fields += isThere ? number(bucket.mean * curve.scale, form) : QString();
            if (hasBand(curve)) {
                fields += isThere ? number(bucket.minimum * curve.scale, form) : QString();
                fields += isThere ? number(bucket.maximum * curve.scale, form) : QString();
            }
        }
        write(fields);
    }
    return table;
}

} // namespace gorizont
