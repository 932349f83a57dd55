#include "ui/weather/weathermodel.h"

#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"

namespace gorizont {

void WeatherModel::setParameters(const QList<WeatherParameter> &parameters, bool isValid)
{
    if (parameters == m_parameters && isValid == m_isValid) {
        return;
    }
    const bool isSameSize = parameters.size() == m_parameters.size();
    if (!isSameSize) {
        beginResetModel();
    }
    m_parameters = parameters;
    m_isValid = isValid;
    if (!isSameSize) {
        endResetModel();
    } else {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int WeatherModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_parameters.size());
}

int WeatherModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString WeatherModel::text(const WeatherParameter &parameter, int column) const
{
    switch (column) {
    case Name: return valuetext::orAbsent(parameter.name);
    case Code: return weathertext::code(parameter);
    case Unit: return valuetext::orAbsent(parameter.unit);
    default: break;
    }
    if (!m_isValid) {
        return valuetext::absent();
    }
    switch (column) {
    case Mean: return weathertext::value(parameter, parameter.mean);
    case Instant: return weathertext::value(parameter, parameter.instant);
    case Minimum: return weathertext::value(parameter, parameter.minimum);
    case Maximum: return weathertext::value(parameter, parameter.maximum);
    case MaxPeriod: return weathertext::value(parameter, parameter.maxPeriod);
    case Deviation: return weathertext::deviation(parameter);
    case Voltage: return weathertext::voltage(parameter.voltage);
    case VoltageInstant: return weathertext::voltage(parameter.voltageInstant);
    default: return {};
    }
}

QVariant WeatherModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const WeatherParameter &parameter = m_parameters.at(index.row());
    switch (role) {
    case Qt::DisplayRole: return text(parameter, index.column());
    case Qt::ToolTipRole: return index.column() == Name ? QVariant(text(parameter, Name)) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() >= Mean ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant WeatherModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section >= Mean ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Name: return isTip ? tr("What the station measures") : tr("Parameter");
    case Code: return isTip ? tr("Code and number of the parameter in the station") : tr("Code");
    case Unit: return isTip ? tr("Unit of all columns but the last two") : tr("Unit");
    case Mean: return isTip ? tr("Mean over the averaging interval of the station") : tr("Mean");
    case Instant: return isTip ? tr("Value of the last seconds") : tr("Now");
    case Minimum: return isTip ? tr("Least value of the averaging interval") : tr("Min.");
    case Maximum: return isTip ? tr("Largest value of the averaging interval") : tr("Max.");
    case MaxPeriod: return isTip ? tr("Largest value since the station was asked before") : tr("Max. since request");
    case Deviation: return isTip ? tr("Root mean square deviation") : tr("σ");
    case Voltage: return isTip ? tr("Measured before any conversion, mean, V or Hz") : tr("Voltage, V");
    case VoltageInstant:
        return isTip ? tr("Measured before any conversion, last seconds, V or Hz") : tr("Voltage now, V");
    default: return {};
    }
}

} // namespace gorizont
