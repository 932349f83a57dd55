#include "core/station/stationconfig.h"

#include "core/station/stationtext.h"

#include <algorithm>

namespace gorizont::station {

QString canonicalName(const QString &name)
{
    static const QStringList fixed{QStringLiteral("ACK.INI"), QStringLiteral("ACK.PAR"), QStringLiteral("ACK.PSE"),
                                   QStringLiteral("ACK.LCD"), QStringLiteral("ACK.FWL"), QStringLiteral("ACK.GAM")};
    static const QStringList corrections{
        QStringLiteral("INPUT"), QStringLiteral("METEO"), QStringLiteral("CORRECT"), QStringLiteral("REAL")};
    const QString plain = latinised(name.toUpper());
    if (fixed.contains(plain)) {
        return plain;
    }
    const qsizetype point = plain.lastIndexOf(u'.');
    const QStringView parameter = QStringView(plain).mid(point + 1);
    const auto isDigit = [](QChar character) { return character >= u'0' && character <= u'9'; };
    const bool isParameter = parameter.size() == 3 && parameter[0] >= u'A' && parameter[0] <= u'Z'
        && isDigit(parameter[1]) && isDigit(parameter[2]);
    return isParameter && point > 0 && corrections.contains(plain.left(point)) ? plain : QString();
}

int StationConfig::indexOf(const ParameterId &id) const
{
    int anyCase = -1;
    for (int i = 0; i < parameters.size(); ++i) {
        const ParameterConfig &parameter = parameters[i];
        if (parameter.id() == id) {
            return i;
        }
        if (anyCase < 0 && parameter.number == id.number && parameter.isA(id.code.toUpper())) {
            anyCase = i;
        }
    }
    return anyCase;
}

int StationConfig::thermometer() const
{
    const auto found = std::find_if(parameters.cbegin(), parameters.cend(), [](const ParameterConfig &parameter) {
        return parameter.isA(u'T');
    });
    return found == parameters.cend() ? -1 : static_cast<int>(found - parameters.cbegin());
}

QList<int> StationConfig::processingOrder() const
{
    QList<int> order;
    const auto append = [&order](int index) {
        if (index >= 0 && !order.contains(index)) {
            order.append(index);
        }
    };
    for (int i = 0; i < parameters.size(); ++i) {
        if (parameters[i].isA(u'U')) {
            append(i);
        }
    }
    for (const BoardConfig &board : boards) {
        for (const BoardInput &place : board.order) {
            append(indexOf(place.parameter));
        }
    }
    for (int i = 0; i < parameters.size(); ++i) {
        append(i);
    }
    return order;
}

std::chrono::seconds StationConfig::averaging(int parameter) const
{
    const auto own = parameters[parameter].averaging;
    return own.count() > 0 ? own : settings.averaging;
}

int StationConfig::instantSeconds(int parameter) const
{
    const auto measures = [this, parameter](const QList<BoardInput> &inputs) {
        return std::any_of(inputs.cbegin(), inputs.cend(), [this, parameter](const BoardInput &input) {
            return indexOf(input.parameter) == parameter;
        });
    };
    for (const BoardConfig &board : boards) {
        const bool isFrequency = board.frequency && indexOf(*board.frequency) == parameter;
        if (isFrequency || measures(board.analogue) || measures(board.digital)) {
            return board.instantSeconds;
        }
    }
    return boards.isEmpty() ? 1 : boards.first().instantSeconds;
}

bool StationConfig::isTest() const
{
    return settings.isTest
        || std::any_of(boards.cbegin(), boards.cend(), [](const BoardConfig &board) { return board.isTest; });
}

int StationConfig::bitOf(qsizetype board, const BoardInput &input) const
{
    return boards[board].firstBit + input.channel;
}

std::optional<int> StationConfig::precipitationBit() const
{
    for (qsizetype board = 0; board < boards.size(); ++board) {
        for (const BoardInput &input : boards[board].digital) {
            if (input.parameter.code.toUpper() == precipitationCode) {
                return bitOf(board, input);
            }
        }
    }
    return {};
}

} // namespace gorizont::station
