#include "ui/pages/columnlayout.h"

#include <QSettings>
#include <QStringList>

#include <algorithm>

namespace gorizont {

namespace {

constexpr int widest = 10000; ///< more is a damaged file

QString keyOf(const QString &table, const char *what)
{
    return QStringLiteral("columns/%1/%2").arg(table, QLatin1String(what));
}

QList<int> numbers(const QString &text, QChar separator)
{
    QList<int> list;
    for (const QString &part : text.split(separator, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int number = part.toInt(&isNumber);
        if (!isNumber) {
            return {};
        }
        list += number;
    }
    return list;
}

/// Every column once; anything else is of another version of the table.
QList<int> readOrder(const QString &text, int columns)
{
    const QList<int> order = numbers(text, u' ');
    QList<int> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (int column = 0; column < sorted.size(); ++column) {
        if (sorted.at(column) != column) {
            return {};
        }
    }
    return order.size() == columns ? order : QList<int>();
}

QMap<int, int> readWidths(const QString &text, int columns)
{
    QMap<int, int> widths;
    for (const QString &part : text.split(u' ', Qt::SkipEmptyParts)) {
        const QList<int> pair = numbers(part, u':');
        if (pair.size() == 2 && pair.first() >= 0 && pair.first() < columns && pair.last() > 0
            && pair.last() < widest) {
            widths.insert(pair.first(), pair.last());
        }
    }
    return widths;
}

} // namespace

ColumnLayout readColumnLayout(const QSettings &settings, const QString &table, int columns)
{
    ColumnLayout layout;
    if (settings.value(keyOf(table, "count")).toInt() != columns) {
        return layout;
    }
    layout.order = readOrder(settings.value(keyOf(table, "order")).toString(), columns);
    layout.widths = readWidths(settings.value(keyOf(table, "widths")).toString(), columns);
    const int sortColumn = settings.value(keyOf(table, "sortColumn"), -1).toInt();
    if (sortColumn >= 0 && sortColumn < columns) {
        layout.sortColumn = sortColumn;
        layout.sortOrder =
            settings.value(keyOf(table, "sortsDown")).toBool() ? Qt::DescendingOrder : Qt::AscendingOrder;
    }
    return layout;
}

void writeColumnLayout(QSettings &settings, const QString &table, int columns, const ColumnLayout &layout)
{
    QStringList order;
    for (const int column : layout.order) {
        order += QString::number(column);
    }
    QStringList widths;
    for (auto width = layout.widths.cbegin(); width != layout.widths.cend(); ++width) {
        widths += QStringLiteral("%1:%2").arg(width.key()).arg(width.value());
    }
    settings.setValue(keyOf(table, "count"), columns);
    settings.setValue(keyOf(table, "order"), order.join(u' '));
    settings.setValue(keyOf(table, "widths"), widths.join(u' '));
    settings.setValue(keyOf(table, "sortColumn"), layout.sortColumn);
    settings.setValue(keyOf(table, "sortsDown"), layout.sortOrder == Qt::DescendingOrder);
}

} // namespace gorizont
