#include "core/devices/mk14/mk14parameters.h"

#include "core/values/weather.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace gorizont::mk14 {

namespace {

class ParameterText
{
    Q_DECLARE_TR_FUNCTIONS(Mk14Parameters)
};

/// Cyrillic letters that look like the Latin ones that are meant.
QChar latin(QChar letter)
{
    static const QString cyrillic = QStringLiteral("АВЕКМНОРСТХаеорсх");
    static const QString alike = QStringLiteral("ABEKMHOPCTXaeopcx");
    const qsizetype at = cyrillic.indexOf(letter);
    return at < 0 ? letter : alike.at(at);
}

void describe(ParameterName &parameter)
{
    if (parameter.code == weathercode::supply) {
        parameter.name = ParameterText::tr("Supply voltage");
        parameter.unit = ParameterText::tr("V");
    } else if (parameter.code.toUpper() == weathercode::temperature) {
        parameter.name = ParameterText::tr("Temperature");
        parameter.unit = QStringLiteral("°C");
    } else if (parameter.code == weathercode::pressure) {
        parameter.name = ParameterText::tr("Pressure");
        parameter.unit = ParameterText::tr("mm Hg");
    } else if (parameter.code == weathercode::humidity) {
        parameter.name = ParameterText::tr("Humidity");
        parameter.unit = QStringLiteral("%");
    } else if (parameter.code == weathercode::windDirection) {
        parameter.name = ParameterText::tr("Wind direction");
        parameter.unit = QStringLiteral("°");
    } else if (parameter.code == weathercode::windSpeed) {
        parameter.name = ParameterText::tr("Wind speed");
        parameter.unit = ParameterText::tr("m/s");
    } else if (parameter.code == weathercode::windVector) {
        parameter.name = ParameterText::tr("Wind speed, mean vector");
        parameter.unit = ParameterText::tr("m/s");
    }
}

int nextNumber(const QList<ParameterName> &parameters, QChar code)
{
    int number = 1;
    for (const ParameterName &parameter : parameters) {
        number = parameter.code == code ? std::max(number, parameter.number + 1) : number;
    }
    return number;
}

} // namespace

QList<ParameterName> usualParameters()
{
    return parametersInList(QStringLiteral("U,T,P,H,A,M")).value_or(QList<ParameterName>());
}

std::optional<QList<ParameterName>> parametersInList(const QString &text)
{
    constexpr int mostDigits = 3;
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    QList<ParameterName> parameters;
    for (const QString &word : text.split(separators, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int number = word.mid(1).toInt(&isNumber);
        const bool hasNumber = word.size() > 1;
        if (!word.front().isLetter() || word.size() > 1 + mostDigits || (hasNumber && (!isNumber || number < 1))) {
            return std::nullopt;
        }
        ParameterName parameter;
        parameter.code = latin(word.front());
        parameter.number = hasNumber ? number : nextNumber(parameters, parameter.code);
        describe(parameter);
        parameters.append(parameter);
    }
    return parameters.isEmpty() ? std::nullopt : std::optional(parameters);
}

} // namespace gorizont::mk14
