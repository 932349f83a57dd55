#include "ui/pages/partlayout.h"

#include "ui/pages/columnlayout.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QSettings>
#include <QSplitter>

namespace gorizont {

namespace {

QString keyOf(const QSplitter &splitter)
{
    return QStringLiteral("splitters/") + splitter.objectName();
}

} // namespace

void keepTables(QSettings &settings, const QWidget &part)
{
    for (const TableView *table : part.findChildren<TableView *>()) {
        const int columns = table->model()->columnCount();
        writeColumnLayout(settings, table->objectName(), columns, table->columns().layout());
    }
}

void restoreTables(const QSettings &settings, const QWidget &part)
{
    for (const TableView *table : part.findChildren<TableView *>()) {
        const int columns = table->model()->columnCount();
        table->columns().setLayout(readColumnLayout(settings, table->objectName(), columns));
    }
}

void keepSplitters(QSettings &settings, const QWidget &part)
{
    for (const QSplitter *splitter : part.findChildren<QSplitter *>()) {
        if (!splitter->objectName().isEmpty()) {
            settings.setValue(keyOf(*splitter), splitter->saveState());
        }
    }
}

void restoreSplitters(const QSettings &settings, const QWidget &part)
{
    for (QSplitter *splitter : part.findChildren<QSplitter *>()) {
        if (!splitter->objectName().isEmpty()) {
            splitter->restoreState(settings.value(keyOf(*splitter)).toByteArray());
        }
    }
}

} // namespace gorizont
