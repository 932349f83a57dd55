#include "tests/ui/modeltext.h"

#include <QStringList>

namespace gorizont::test {

namespace {

void addRows(const QAbstractItemModel &model, const QModelIndex &parent, int depth, QStringList &lines)
{
    for (int row = 0; row < model.rowCount(parent); ++row) {
        QStringList cells;
        for (int column = 0; column < model.columnCount(parent); ++column) {
            cells += model.index(row, column, parent).data().toString();
        }
        lines += QString(2 * depth, u' ') + cells.join(QStringLiteral(" | "));
        addRows(model, model.index(row, 0, parent), depth + 1, lines);
    }
}

} // namespace

QString modelText(const QAbstractItemModel &model, bool withHeader)
{
    QStringList lines;
    if (withHeader) {
        QStringList cells;
        for (int column = 0; column < model.columnCount(); ++column) {
            cells += model.headerData(column, Qt::Horizontal).toString();
        }
        lines += cells.join(QStringLiteral(" | "));
    }
    addRows(model, {}, 0, lines);
    return lines.join(u'\n');
}

} // namespace gorizont::test
