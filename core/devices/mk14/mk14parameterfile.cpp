#include "core/devices/mk14/mk14parameters.h"

#include <QStringDecoder>

#include <algorithm>

namespace gorizont::mk14 {

namespace {

constexpr qsizetype neededFields = 5; ///< name, unit, short name, code, number; the others concern the station only

quint8 byteOf(char c)
{
    return static_cast<quint8>(c);
}

bool isBetween(char c, int first, int last)
{
    return byteOf(c) >= first && byteOf(c) <= last;
}

/// Capitals and half of the small letters lie at 80…AF in CP866 and at C0…DF in Windows-1251 (capitals), where CP866 has frames.
bool isCp866(const QByteArray &bytes)
{
    const auto there = [&bytes](int first, int last) {
        return std::count_if(bytes.begin(), bytes.end(), [=](char c) { return isBetween(c, first, last); });
    };
    return there(0x80, 0xAF) > there(0xC0, 0xDF);
}

/// The letters of the alphabet and the degree; of anything else there is nothing in a name.
QChar character(char c, bool is866)
{
    const int code = byteOf(c);
    const auto at = [code](int first, int unicode) { return QChar(static_cast<char16_t>(unicode + code - first)); };
    if (code < 0x80) {
        return at(0, 0);
    }
    if (is866) {
        return isBetween(c, 0x80, 0xAF) ? at(0x80, 0x410)
            : isBetween(c, 0xE0, 0xEF)  ? at(0xE0, 0x440)
            : code == 0xF0              ? QChar(u'Ё')
            : code == 0xF1              ? QChar(u'ё')
            : code == 0xF8              ? QChar(u'°')
                                        : QChar(QChar::ReplacementCharacter);
    }
    return code >= 0xC0 ? at(0xC0, 0x410)
        : code == 0xA8  ? QChar(u'Ё')
        : code == 0xB8  ? QChar(u'ё')
        : code == 0xB0  ? QChar(u'°')
                        : QChar(QChar::ReplacementCharacter);
}

QString decoded(const QByteArray &bytes)
{
    QStringDecoder utf8(QStringDecoder::Utf8);
    const QString text = utf8(bytes);
    if (!utf8.hasError()) {
        return text;
    }
    const bool is866 = isCp866(bytes);
    QString old(bytes.size(), QChar());
    std::transform(bytes.begin(), bytes.end(), old.begin(), [is866](char c) { return character(c, is866); });
    return old;
}

/// Parted by blanks; text in double quotes is one field; a semicolon outside of them ends the line.
QStringList fieldsOf(const QString &line)
{
    QStringList fields;
    bool isQuoted = false;
    bool isInField = false;
    for (const QChar c : line) {
        if (c == u'"') {
            isQuoted = !isQuoted;
            if (isQuoted && !isInField) {
                fields.append(QString());
                isInField = true;
            }
        } else if (!isQuoted && c == u';') {
            break;
        } else if (!isQuoted && c.isSpace()) {
            isInField = false;
        } else {
            if (!isInField) {
                fields.append(QString());
                isInField = true;
            }
            fields.last().append(c);
        }
    }
    return fields;
}

/// A dash is "none".
QString orNothing(const QString &field)
{
    return field == u"-" || field == u"–" || field == u"—" ? QString() : field;
}

std::optional<ParameterName> parameterIn(const QStringList &fields)
{
    if (fields.size() < neededFields || fields.at(3).size() != 1 || !fields.at(3).front().isLetter()) {
        return std::nullopt;
    }
    bool isNumber = false;
    const int number = fields.at(4).toInt(&isNumber);
    if (!isNumber || number < 1) {
        return std::nullopt;
    }
    return ParameterName{fields.at(3).front(), number, orNothing(fields.at(0)), orNothing(fields.at(1))};
}

} // namespace

ParameterFile parametersInFile(const QByteArray &bytes)
{
    ParameterFile file;
    int line = 0;
    const QString text = decoded(bytes);
    for (const QString &content : text.split(u'\n')) {
        ++line;
        const QStringList fields = fieldsOf(content);
        if (fields.isEmpty()) {
            continue;
        }
        if (const auto parameter = parameterIn(fields)) {
            file.parameters.append(*parameter);
        } else {
            file.badLines.append(line);
        }
    }
    return file;
}

} // namespace gorizont::mk14
