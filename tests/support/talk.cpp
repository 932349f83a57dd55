#include "tests/support/talk.h"

namespace gorizont::test {

namespace {

constexpr std::chrono::milliseconds betweenPieces(1);

/// What the reader of the ini derives from the name and the options (spec/gorizont.md, section 1).
void applyKeywords(SensorConfig &sensor)
{
    const NameKeywords keywords = readKeywords(sensor.name);
    const bool isAnD3 = keywords.type == SensorType::AnD3;
    sensor.type = keywords.type;
    sensor.model = keywords.model;
    sensor.isOn = true;
    sensor.measuresTilt = isAnD3 || keywords.type == SensorType::InD || keywords.type == SensorType::UsmIsn;
    sensor.measuresTemperature = isAnD3 || keywords.hasThermometer;
    sensor.measuresAcceleration = isAnD3 && sensor.options.value(QStringLiteral("accelon")) != QLatin1String("0");
    sensor.hasThermostat = keywords.hasThermostat;
}

bool applyHeader(SensorConfig &sensor, const QString &key, const QString &value)
{
    bool isGood = true;
    if (key == QLatin1String("name")) {
        sensor.name = value;
    } else if (key == QLatin1String("address")) {
        sensor.address = value.toInt(&isGood);
    } else if (key == QLatin1String("number")) {
        sensor.number = value.toInt(&isGood);
    } else {
        sensor.options.insert(key.toLower(), value);
    }
    return isGood && !value.isEmpty();
}

/// Empty: not hexadecimal bytes.
QByteArray strictHex(const QString &text)
{
    const QByteArray digits = text.toLatin1().replace(' ', "");
    const QByteArray bytes = QByteArray::fromHex(digits);
    return bytes.toHex() == digits.toLower() ? bytes : QByteArray();
}

bool addSent(Talk &talk, const QByteArray &bytes)
{
    if (talk.groups.isEmpty() || !talk.groups.last().expectations.isEmpty()) {
        talk.groups.append(Talk::Group());
    }
    talk.groups.last().exchanges.append({bytes, {}});
    return !bytes.isEmpty();
}

bool addReceived(Talk &talk, const QByteArray &bytes)
{
    if (bytes.isEmpty() || talk.groups.isEmpty() || !talk.groups.last().expectations.isEmpty()) {
        return false;
    }
    talk.groups.last().exchanges.last().pieces.append({bytes, betweenPieces});
    return true;
}

bool addExpectation(Talk &talk, const Talk::Expectation &expectation)
{
    if (expectation.value.isEmpty() || talk.groups.isEmpty()) {
        return false;
    }
    talk.groups.last().expectations.append(expectation);
    return true;
}

bool addLine(Talk &talk, const QString &line, int number)
{
    const QString content = line.mid(1).simplified();
    const QString key = content.section(u' ', 0, 0);
    const QString value = content.section(u' ', 1);
    switch (line.at(0).unicode()) {
    case u'#': return true;
    case u'@': return applyHeader(talk.sensor, key, value);
    case u'>': return addSent(talk, strictHex(content));
    case u'<': return addReceived(talk, strictHex(content));
    case u'=': return addExpectation(talk, {key, value, number});
    default: return false;
    }
}

} // namespace

Talk parseTalk(const QByteArray &text)
{
    Talk talk;
    talk.sensor.number = 1;
    const QStringList lines = QString::fromUtf8(text).split(u'\n');
    for (int i = 0; i < lines.size(); ++i) {
        const QString line = lines.at(i).trimmed();
        if (!line.isEmpty() && !addLine(talk, line, i + 1)) {
            talk.mistakes.append(QStringLiteral("line %1 is not understood: %2").arg(i + 1).arg(line));
        }
    }
    applyKeywords(talk.sensor);
    if (talk.groups.isEmpty() || talk.groups.last().expectations.isEmpty()) {
        talk.mistakes.append(QStringLiteral("the last exchange has no expectation"));
    }
    return talk;
}

} // namespace gorizont::test
