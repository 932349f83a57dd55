#include "ui/models/propertymodel.h"

#include "ui/models/colours.h"
#include "ui/models/icons.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace gorizont {

namespace {

/// \a shown: what the cell may be too narrow for.
QString toolTip(const Property &property, const QString &shown)
{
    QStringList lines{shown, property.replaced, property.note};
    if (!property.key.isEmpty()) {
        lines += PropertyModel::tr("in the configuration file: %1").arg(property.key);
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
}

QVariant decoration(const Property &property)
{
    if (!property.replaced.isEmpty()) {
        return icons::state(Health::Warning);
    }
    return property.health ? QVariant(icons::state(*property.health)) : QVariant();
}

} // namespace

PropertyModel::PropertyModel(bool hasNotes, QObject *parent)
    : QAbstractTableModel(parent)
    , m_hasNotes(hasNotes)
{
}

bool PropertyModel::hasSameNames(const Properties &properties) const
{
    return std::equal(
        properties.cbegin(), properties.cend(), m_properties.cbegin(), m_properties.cend(),
        [](const Property &a, const Property &b) { return a.name == b.name && a.isSection == b.isSection; });
}

void PropertyModel::setProperties(const Properties &properties)
{
    if (!hasSameNames(properties)) {
        beginResetModel();
        m_properties = properties;
        endResetModel();
        return;
    }
    for (qsizetype i = 0; i < properties.size(); ++i) {
        if (m_properties.at(i) != properties.at(i)) {
            m_properties[i] = properties.at(i);
            const int row = static_cast<int>(i);
            Q_EMIT dataChanged(index(row, Value), index(row, columnCount() - 1));
        }
    }
}

int PropertyModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_properties.size());
}

int PropertyModel::columnCount(const QModelIndex &parent) const
{
    if (parent.isValid()) {
        return 0;
    }
    return m_hasNotes ? ColumnCount : Note;
}

QVariant PropertyModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Property &property = m_properties.at(index.row());
    const QPalette palette = QGuiApplication::palette();
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Name: return property.name;
        case Value: return property.value;
        case Note: return property.replaced.isEmpty() ? property.note : property.replaced;
        default: return {};
        }
    case Qt::ToolTipRole: return toolTip(property, index.column() == Value ? property.value : QString());
    case Qt::DecorationRole: return index.column() == Value ? decoration(property) : QVariant();
    case Qt::FontRole:
        if (property.isSection) {
            QFont bold;
            bold.setBold(true);
            return bold;
        }
        return {};
    case Qt::BackgroundRole: return property.isSection ? QVariant(palette.brush(QPalette::Button)) : QVariant();
    case Qt::ForegroundRole:
        return index.column() == Note && property.replaced.isEmpty() ? QVariant(colours::mutedText()) : QVariant();
    default: return {};
    }
}

QVariant PropertyModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | Qt::AlignLeft);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Name: return tr("Parameter");
    case Value: return tr("Value");
    case Note: return tr("Note");
    default: return {};
    }
}

Qt::ItemFlags PropertyModel::flags(const QModelIndex &index) const
{
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren : Qt::NoItemFlags;
}

} // namespace gorizont
