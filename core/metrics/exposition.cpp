#include "core/metrics/exposition.h"

#include <QLocale>

#include <cmath>

namespace gorizont {

namespace {

QByteArray escaped(const QString &text, bool isQuoted)
{
    QString result = text;
    result.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n"));
    if (isQuoted) {
        result.replace(u'"', QStringLiteral("\\\""));
    }
    return result.toUtf8();
}

QByteArray number(double value)
{
    if (std::isnan(value)) {
        return QByteArrayLiteral("NaN");
    }
    if (std::isinf(value)) {
        return value > 0 ? QByteArrayLiteral("+Inf") : QByteArrayLiteral("-Inf");
    }
    constexpr double exactWholes = 1e15;
    const bool isWhole = std::abs(value) < exactWholes && std::trunc(value) == value;
    return isWhole ? QByteArray::number(static_cast<qint64>(value))
                   : QByteArray::number(value, 'g', QLocale::FloatingPointShortest);
}

QByteArray sampleLine(const QByteArray &name, const MetricSample &sample)
{
    QByteArrayList labels;
    for (const auto &[label, text] : sample.labels) {
        labels.append(label + "=\"" + escaped(text, true) + '"');
    }
    const QByteArray list = labels.isEmpty() ? QByteArray() : '{' + labels.join(',') + '}';
    return name + list + ' ' + number(sample.value) + '\n';
}

} // namespace

QByteArray expositionText(const MetricFamilies &families)
{
    QByteArray text;
    for (const MetricFamily &family : families) {
        if (family.samples.isEmpty()) {
            continue;
        }
        text += "# HELP " + family.name + ' ' + escaped(family.help, false) + '\n';
        text += "# TYPE " + family.name + (family.type == MetricFamily::Type::Counter ? " counter\n" : " gauge\n");
        for (const MetricSample &sample : family.samples) {
            text += sampleLine(family.name, sample);
        }
    }
    return text;
}

} // namespace gorizont
