#include "core/config/inifile.h"

#include "core/config/iniline.h"

#include <algorithm>

namespace gorizont {

namespace {

QString foldedKey(const QString &key)
{
    const QString folded = key.toCaseFolded();
    const bool isOldSpelling = folded == QStringLiteral("scrcerr") || folded == QStringLiteral("scrcerrors");
    return isOldSpelling ? QStringLiteral("scrcerror") : folded;
}

QString entryText(const QString &key, const QString &value)
{
    return key + u'=' + value;
}

QString onOneLine(QString value)
{
    return value.replace(u'\r', u' ').replace(u'\n', u' ').trimmed();
}

} // namespace

IniFile IniFile::fromBytes(const QByteArray &bytes)
{
    IniFile file;
    if (!bytes.isEmpty()) {
        file.m_encoding = detectEncoding(bytes);
        file.m_lines = splitLines(bytes.mid(byteOrderMark(file.m_encoding).size()), file.m_encoding);
        file.parse();
    }
    return file;
}

QByteArray IniFile::toBytes() const
{
    return byteOrderMark(m_encoding) + m_lines.join();
}

bool IniFile::hasSection(const QString &section) const
{
    return this->section(section) != nullptr;
}

QStringList IniFile::sections() const
{
    QStringList names;
    for (const Section &section : m_sections) {
        if (!section.name.isEmpty()) {
            names.append(section.name);
        }
    }
    return names;
}

QList<IniFile::Entry> IniFile::entries(const QString &section) const
{
    const Section *found = this->section(section);
    if (!found) {
        return {};
    }
    QList<qsizetype> indices = found->entryOfKey.values();
    std::sort(indices.begin(), indices.end());
    QList<Entry> entries;
    entries.reserve(indices.size());
    for (const qsizetype index : indices) {
        entries.append(m_entries.at(index));
    }
    return entries;
}

int IniFile::sectionLine(const QString &section) const
{
    const Section *found = this->section(section);
    return found ? found->line : 0;
}

std::optional<IniFile::Entry> IniFile::find(const QString &section, const QString &key) const
{
    const Section *found = this->section(section);
    const qsizetype index = found ? found->entryOfKey.value(foldedKey(key), -1) : -1;
    if (index < 0) {
        return std::nullopt;
    }
    return m_entries.at(index);
}

bool IniFile::canHold(const QString &value) const
{
    return decodeText(encodeText(value, m_encoding), m_encoding) == value;
}

void IniFile::setValue(const QString &section, const QString &key, const QString &value)
{
    const QString written = onOneLine(value);
    if (const auto entry = find(section, key)) {
        replaceValue(*entry, key, written);
    } else if (const Section *found = this->section(section)) {
        insertLines(found->lastLine, {entryText(key, written)});
    } else if (section.isEmpty()) {
        insertLines(0, {entryText(key, written)});
    } else {
        insertLines(m_lines.size(), {u'[' + section + u']', entryText(key, written)});
    }
    parse();
}

void IniFile::parse()
{
    m_entries.clear();
    m_repetitions.clear();
    m_sections.clear();
    m_sectionOfName.clear();
    Place place;
    for (int line = 1; line <= m_lines.size(); ++line) {
        const IniLine read = readIniLine(decodeText(m_lines.at(line - 1), m_encoding));
        switch (read.kind) {
        case IniLine::Kind::Ignored: break;
        case IniLine::Kind::Header: place = enterSection(read.name, line); break;
        case IniLine::Kind::Entry:
            if (place.section < 0) {
                place = enterSection(QString(), line);
            }
            addEntry(place, {m_sections.at(place.section).name, read.name, read.value, line});
            break;
        }
    }
}

IniFile::Place IniFile::enterSection(const QString &name, int line)
{
    const QString folded = name.toCaseFolded();
    const auto known = m_sectionOfName.constFind(folded);
    if (known != m_sectionOfName.constEnd()) {
        m_repetitions.append({name, {}, {}, line});
        return {*known, true};
    }
    const qsizetype index = m_sections.size();
    m_sections.append({name, line, line, {}});
    m_sectionOfName.insert(folded, index);
    return {index, false};
}

void IniFile::addEntry(const Place &place, const Entry &entry)
{
    Section &section = m_sections[place.section];
    const qsizetype known = section.entryOfKey.size();
    qsizetype &index = section.entryOfKey[foldedKey(entry.key)];
    if (section.entryOfKey.size() > known) {
        index = m_entries.size();
    } else if (!place.isRepeated) {
        m_repetitions.append(entry);
    }
    m_entries.append(entry);
    if (!place.isRepeated) {
        section.lastLine = entry.line;
    }
}

const IniFile::Section *IniFile::section(const QString &name) const
{
    const qsizetype index = m_sectionOfName.value(name.toCaseFolded(), -1);
    return index < 0 ? nullptr : &m_sections.at(index);
}

void IniFile::replaceValue(const Entry &entry, const QString &key, const QString &value)
{
    QByteArray &line = m_lines[entry.line - 1];
    const bool isSameKey = entry.key.compare(key, Qt::CaseInsensitive) == 0;
    line = encodeText(withKeyAndValue(decodeText(line, m_encoding), isSameKey ? entry.key : key, value), m_encoding);
}

void IniFile::insertLines(qsizetype at, const QStringList &texts)
{
    QString end = m_lines.isEmpty() ? QString() : lineEndOf(decodeText(m_lines.first(), m_encoding)).toString();
    if (end.isEmpty()) {
        end = QStringLiteral("\r\n");
    }
    if (at > 0) {
        const QString before = decodeText(m_lines.at(at - 1), m_encoding);
        if (lineEndOf(before).isEmpty()) {
            m_lines[at - 1] = encodeText(before + end, m_encoding);
        } else {
            end = lineEndOf(before).toString();
        }
    }
    for (const QString &text : texts) {
        m_lines.insert(at++, encodeText(text + end, m_encoding));
    }
}

} // namespace gorizont
