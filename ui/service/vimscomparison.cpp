#include "ui/service/vimscomparison.h"

#include "core/devices/lvims/lvimssettings.h"

#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <map>

namespace gorizont {

using namespace lvims;

namespace {

struct Row
{
    QString inUse;
    QString prepared;
    QString wanted;
};

/// Of everything that differs between any two of the three, in the order of the settings.
QList<std::pair<QString, Row>> rowsOf(
    const QList<quint16> &inUse, const QList<quint16> &prepared, const QList<quint16> &wanted)
{
    std::map<QString, Row> undescribed;
    for (const SettingDifference &difference : lvims::differences(inUse, prepared)) {
        undescribed[difference.name] = {difference.before, difference.after, difference.after};
    }
    for (const SettingDifference &difference : lvims::differences(prepared, wanted)) {
        Row &row = undescribed[difference.name];
        row = {row.inUse.isNull() ? difference.before : row.inUse, difference.before, difference.after};
    }
    QList<std::pair<QString, Row>> rows;
    for (const Setting &setting : allSettings()) {
        if (undescribed.erase(setting.name) > 0) {
            rows.append(
                {setting.name, {valueOf(inUse, setting), valueOf(prepared, setting), valueOf(wanted, setting)}});
        }
    }
    for (const auto &[name, row] : undescribed) {
        rows.append({name, row});
    }
    return rows;
}

} // namespace

VimsComparison::VimsComparison(QWidget *parent)
    : QWidget(parent)
    , m_table(new QTableWidget(0, 4, this))
{
    m_table->setObjectName(QStringLiteral("comparison"));
    m_table->setAccessibleName(tr("Settings that differ"));
    m_table->setHorizontalHeaderLabels({tr("Setting"), tr("In use (CUR)"), tr("Prepared (MUT)"), tr("In this window")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_table);
}

void VimsComparison::compare(const QList<quint16> &inUse, const QList<quint16> &prepared, const QList<quint16> &wanted)
{
    const auto rows = inUse.isEmpty() ? QList<std::pair<QString, Row>>() : rowsOf(inUse, prepared, wanted);
    m_table->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const auto &[name, row] = rows.at(i);
        const QStringList texts{name, row.inUse, row.prepared, row.wanted};
        for (int column = 0; column < texts.size(); ++column) {
            auto *item = new QTableWidgetItem(texts.at(column));
            QFont font = m_table->font();
            font.setBold(column > 1 && texts.at(column) != texts.at(column - 1)); // where it changes
            item->setFont(font);
            item->setToolTip(texts.at(column));
            m_table->setItem(i, column, item);
        }
    }
}

int VimsComparison::differences() const
{
    return m_table->rowCount();
}

QWidgetList VimsComparison::tabOrder() const
{
    return {m_table};
}

} // namespace gorizont
