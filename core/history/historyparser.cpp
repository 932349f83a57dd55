#include "core/history/historyparser.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

constexpr qsizetype fieldsOfGroup = 5;
constexpr int firstYear = 2000; ///< of two digits

/// A number of exactly the digits of \a text; empty: anything else is there.
std::optional<int> digits(QByteArrayView text)
{
    int value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') {
            return {};
        }
        value = value * 10 + (c - '0');
    }
    return value;
}

/// Three numbers of two digits with \a separator between.
std::optional<std::array<int, 3>> three(QByteArrayView text, char separator)
{
    if (text.size() != 8 || text[2] != separator || text[5] != separator) {
        return {};
    }
    const auto first = digits(text.sliced(0, 2));
    const auto second = digits(text.sliced(3, 2));
    const auto third = digits(text.sliced(6, 2));
    return first && second && third ? std::optional(std::array{*first, *second, *third}) : std::nullopt;
}

/// Some versions wrote a decimal comma.
std::optional<double> number(QByteArrayView text)
{
    text = text.trimmed();
    QVarLengthArray<char, 32> plain(text.cbegin(), text.cend());
    std::replace(plain.begin(), plain.end(), ',', '.');
    double value = 0;
    const char *end = plain.data() + plain.size();
    const auto result = std::from_chars(plain.data(), end, value);
    const bool isNumber = result.ec == std::errc() && result.ptr == end && !plain.isEmpty() && std::isfinite(value);
    return isNumber ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<quint16> parseStatusDigits(QByteArrayView text)
{
    constexpr qsizetype size = 17;
    if (text.size() != size || text[2] != ' ' || text[7] != ' ' || text[12] != ' ') {
        return {};
    }
    const std::optional<int> code = digits(text.sliced(0, 2).trimmed());
    if (!code || *code > 15 || text.sliced(0, 2).trimmed().isEmpty()) {
        return {};
    }
    int word = *code;
    for (qsizetype i = 3; i < size; ++i) {
        if (i == 7 || i == 12) {
            continue;
        }
        if (text[i] != '0' && text[i] != '1') {
            return {};
        }
        word = word * 2 + (text[i] - '0');
    }
    return static_cast<quint16>(word);
}

std::optional<HistoryRow> HistoryRow::parse(QByteArrayView line)
{
    while (line.endsWith('\n') || line.endsWith('\r')) {
        line.chop(1);
    }
    constexpr qsizetype stamp = 17;
    if (line.size() < stamp + 1 || line[8] != ' ' || line[stamp] != '\t') {
        return {};
    }
    const auto time = three(line.sliced(0, 8), ':');
    const auto date = three(line.sliced(9, 8), '.');
    if (!time || !date) {
        return {};
    }
    HistoryRow row;
    row.m_time = QTime((*time)[0], (*time)[1], (*time)[2]);
    row.m_date = QDate(firstYear + (*date)[2], (*date)[1], (*date)[0]);
    if (!row.m_time.isValid() || !row.m_date.isValid()) {
        return {};
    }
    qsizetype tab = line.indexOf('\t', stamp + 1); // behind the word of channels
    while (tab >= 0) {
        const qsizetype next = line.indexOf('\t', tab + 1);
        row.m_fields.append(line.sliced(tab + 1, (next < 0 ? line.size() : next) - tab - 1));
        tab = next;
    }
    return row;
}

qsizetype HistoryRow::groups() const
{
    return m_fields.size() / fieldsOfGroup;
}

std::optional<HistoryGroup> HistoryRow::group(qsizetype index) const
{
    if (index < 0 || index >= groups()) {
        return {};
    }
    const QByteArrayView *fields = m_fields.constData() + index * fieldsOfGroup;
    const std::optional<quint16> status = parseStatusDigits(fields[4]);
    if (!status) {
        return {};
    }
    return HistoryGroup{{number(fields[0]), number(fields[1]), number(fields[2]), number(fields[3])}, *status};
}

Reading tiltReading(const HistoryGroup &group)
{
    Reading reading;
    reading.isAnswer = true;
    reading.status = group.status;
    if (group.values[0] && group.values[1]) {
        reading.tilt = Tilt{*group.values[0], *group.values[1]};
    }
    reading.temperature = group.values[2];
    reading.heaterPower = group.values[3];
    return reading;
}

Reading accelerationReading(const HistoryGroup &group)
{
    Reading reading;
    reading.isAnswer = true;
    reading.status = group.status;
    const auto &[maximumX, maximumY, rmsX, rmsY] = group.values;
    if (maximumX && maximumY && rmsX && rmsY) {
        const double degrees = std::atan2(*maximumY, *maximumX) * 180 / std::numbers::pi;
        reading.acceleration = AccelStatistics{
            std::hypot(*maximumX, *maximumY), *maximumX, *maximumY, degrees < 0 ? degrees + 360 : degrees,
            std::hypot(*rmsX, *rmsY),         *rmsX,     *rmsY};
    }
    return reading;
}

std::optional<SampleFileName> parseSampleFileName(const QString &name)
{
    constexpr qsizetype stamp = 17; // 16_03_29_22_46_09
    const QByteArray text = name.toLatin1();
    if (text.size() < stamp + 7 || text[stamp] != '_' || text[8] != '_' || !text.toLower().endsWith(".wrd")) {
        return {};
    }
    const QByteArrayView view(text);
    const auto date = three(view.sliced(0, 8), '_');
    const auto time = three(view.sliced(9, 8), '_');
    const char axis = text[text.size() - 5];
    const QByteArrayView number = view.sliced(stamp + 1, text.size() - 5 - stamp - 1);
    const std::optional<int> sensor = number.isEmpty() || number.size() > 6 ? std::nullopt : digits(number);
    if (!date || !time || !sensor || (axis != 'X' && axis != 'Y')) {
        return {};
    }
    const QDateTime start(
        QDate(firstYear + (*date)[0], (*date)[1], (*date)[2]), QTime((*time)[0], (*time)[1], (*time)[2]), Qt::UTC);
    return start.isValid() ? std::optional(SampleFileName{start, *sensor, axis}) : std::nullopt;
}

} // namespace gorizont
