#include "core/station/stationtext.h"

#include "core/station/cp866.h"
#include "core/values/windows1251.h"

#include <cmath>

namespace gorizont::station {

namespace {

constexpr QStringView cyrillic = u"АВЕКМНОРСТУХаеорсух";
constexpr QStringView latin = u"ABEKMHOPCTYXaeopcyx";
static_assert(cyrillic.size() == latin.size());

constexpr QChar endOfFile{0x1A}; ///< DOS editors close a text with it

unsigned char codeAt(const QByteArray &bytes, qsizetype at)
{
    return at >= 0 && at < bytes.size() ? static_cast<unsigned char>(bytes.at(at)) : 0;
}

bool isLoneDegree(const QByteArray &bytes, qsizetype at)
{
    constexpr unsigned char degree = 0xF8;
    constexpr unsigned char letters = 0xC0; // of Windows-1251
    return codeAt(bytes, at) == degree && codeAt(bytes, at - 1) < letters && codeAt(bytes, at + 1) < letters;
}

bool isCp866(const QByteArray &bytes)
{
    qsizetype dos = 0;
    qsizetype windows = 0;
    for (qsizetype at = 0; at < bytes.size(); ++at) {
        const unsigned char code = codeAt(bytes, at);
        if ((code >= 0x80 && code <= 0xAF) || isLoneDegree(bytes, at)) {
            ++dos;
        } else if ((code >= 0xC0 && code <= 0xDF) || code >= 0xF0) {
            ++windows;
        }
    }
    return dos > windows;
}

bool isBlank(QChar character)
{
    return character.isSpace();
}

/// Cuts one line, from \a at on, into fields.
Record fieldsOf(QStringView line, int number)
{
    Record record;
    record.line = number;
    for (qsizetype at = 0; at < line.size();) {
        if (isBlank(line[at])) {
            ++at;
        } else if (line[at] == u';') {
            break;
        } else if (line[at] == u'"') {
            const qsizetype end = line.indexOf(u'"', at + 1);
            record.isQuoteOpen = end < 0;
            record.fields.append({line.mid(at + 1, end < 0 ? -1 : end - at - 1).toString(), true});
            at = end < 0 ? line.size() : end + 1;
        } else {
            const qsizetype start = at;
            while (at < line.size() && !isBlank(line[at]) && line[at] != u';' && line[at] != u'"') {
                ++at;
            }
            record.fields.append({line.mid(start, at - start).toString(), false});
        }
    }
    return record;
}

} // namespace

QString decodeStationText(const QByteArray &bytes)
{
    static const QByteArray mark = QByteArrayLiteral("\xEF\xBB\xBF");
    QString text;
    if (bytes.startsWith(mark)) {
        text = QString::fromUtf8(bytes.sliced(mark.size()));
    } else if (bytes.isValidUtf8()) {
        text = QString::fromUtf8(bytes);
    } else {
        text = isCp866(bytes) ? decodeCp866(bytes) : decodeWindows1251(bytes);
    }
    const qsizetype end = text.indexOf(endOfFile);
    return end < 0 ? text : text.left(end);
}

bool Field::isNone() const
{
    return !isQuoted && (text == u"-" || text == u"–" || text == u"—");
}

QList<Record> recordsOf(const QString &text)
{
    QList<Record> records;
    int number = 0;
    for (qsizetype start = 0; start < text.size();) {
        qsizetype end = start;
        while (end < text.size() && text[end] != u'\n' && text[end] != u'\r') {
            ++end;
        }
        Record record = fieldsOf(QStringView(text).mid(start, end - start), ++number);
        if (!record.fields.isEmpty()) {
            records.append(std::move(record));
        }
        const bool isPair = end + 1 < text.size() && text[end] == u'\r' && text[end + 1] == u'\n';
        start = end + (isPair ? 2 : 1);
    }
    return records;
}

QChar latinised(QChar letter)
{
    const qsizetype at = cyrillic.indexOf(letter);
    return at < 0 ? letter : latin[at];
}

QString latinised(QString text)
{
    for (QChar &letter : text) {
        letter = latinised(letter);
    }
    return text;
}

std::optional<double> numberOf(QStringView text)
{
    bool isNumber = false;
    const double value = text.toString().replace(u',', u'.').toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace gorizont::station
