#include "core/config/iniline.h"

#include <algorithm>
#include <array>

namespace gorizont {

namespace {

bool isComment(QStringView trimmed)
{
    constexpr std::array<QStringView, 4> signs{u";", u"//", u"#", u",*"};
    return std::any_of(signs.begin(), signs.end(), [trimmed](QStringView sign) { return trimmed.startsWith(sign); });
}

/// \a part must lie inside \a text.
qsizetype positionIn(QStringView text, QStringView part)
{
    return part.isEmpty() ? text.size() : part.data() - text.data();
}

IniLine header(QStringView text, QStringView trimmed, qsizetype nameSize)
{
    const QStringView name = trimmed.mid(1, nameSize).trimmed();
    return {IniLine::Kind::Header, name.toString(), positionIn(text, name), {}, 0};
}

} // namespace

IniLine readIniLine(QStringView text)
{
    text.chop(lineEndOf(text).size());
    const QStringView trimmed = text.trimmed();
    if (trimmed.isEmpty() || isComment(trimmed)) {
        return {};
    }
    const qsizetype bracket = trimmed.indexOf(u']');
    const qsizetype equals = text.indexOf(u'=');
    if (trimmed.startsWith(u'[') && (bracket > 0 || equals < 0)) {
        return header(text, trimmed, bracket > 0 ? bracket - 1 : trimmed.size() - 1);
    }
    const QStringView key = text.left(qMax<qsizetype>(equals, 0)).trimmed();
    if (key.isEmpty()) {
        return {};
    }
    const QStringView value = text.mid(equals + 1).trimmed();
    return {IniLine::Kind::Entry, key.toString(), positionIn(text, key), value.toString(), positionIn(text, value)};
}

QStringView lineEndOf(QStringView text)
{
    const qsizetype size = text.endsWith(u"\r\n") ? 2 : text.endsWith(u'\n') || text.endsWith(u'\r') ? 1 : 0;
    return text.last(size);
}

QString withKeyAndValue(const QString &text, const QString &key, const QString &value)
{
    const IniLine line = readIniLine(text);
    QString changed = text;
    changed.replace(line.valueBegin, line.value.size(), value);
    changed.replace(line.nameBegin, line.name.size(), key);
    return changed;
}

} // namespace gorizont
