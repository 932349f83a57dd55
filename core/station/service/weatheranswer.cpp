#include "core/station/service/weatheranswer.h"

#include <algorithm>

namespace gorizont::station {

namespace {

std::optional<float> narrowed(const std::optional<double> &value)
{
    return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

std::optional<double> widened(const std::optional<float> &value)
{
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
}

bool hasValue(const ack::Values &values)
{
    return std::any_of(values.begin(), values.end(), [](const auto &value) { return value.has_value(); });
}

} // namespace

ack::Answer answerOf(int command, const Weather &weather, qsizetype count, const WindExtras &extras)
{
    ack::Answer answer;
    answer.digital = weather.digital;
    const auto members = ack::membersOf(command);
    for (const WeatherParameter &parameter : weather.parameters.first(std::min(count, weather.parameters.size()))) {
        ack::Values values;
        for (const auto member : members) {
            values.append(narrowed(parameter.*member));
        }
        answer.parameters.append(values);
    }
    if (command == ack::lastDataCommand) {
        answer.extras = {
            narrowed(extras.directionDeviation), narrowed(extras.speedDeviation), narrowed(extras.speedMaximum)};
        for (const PrecipitationEvent &event : weather.events) {
            answer.precipitation.append(static_cast<qint32>(event.isStart ? event.time : -event.time));
        }
    }
    if (std::none_of(answer.parameters.begin(), answer.parameters.end(), hasValue)) {
        answer.parameters.clear();
    }
    return answer;
}

Weather weatherOf(int command, const ack::Answer &answer, const QList<std::optional<ParameterId>> &ids)
{
    Weather weather;
    weather.digital = answer.digital;
    const auto members = ack::membersOf(command);
    for (qsizetype i = 0; i < answer.parameters.size(); ++i) {
        WeatherParameter parameter;
        const auto id = ids.value(i);
        parameter.code = id ? id->code : QChar();
        parameter.number = id ? id->number : static_cast<int>(i) + 1;
        for (qsizetype k = 0; k < members.size(); ++k) {
            parameter.*(members.at(k)) = widened(answer.parameters.at(i).value(k));
        }
        weather.parameters.append(parameter);
    }
    for (const qint32 time : answer.precipitation) {
        weather.events.append({time > 0, qAbs(qint64{time})});
    }
    return weather;
}

WindExtras extrasOf(const ack::Answer &answer)
{
    return {widened(answer.extras.value(0)), widened(answer.extras.value(1)), widened(answer.extras.value(2))};
}

} // namespace gorizont::station
