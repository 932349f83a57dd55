#pragma once

#include "core/config/textlines.h"

#include <QByteArrayList>
#include <QHash>
#include <QList>
#include <QString>

#include <optional>

namespace gorizont {

/// Text of an ini file ⇄ sections, keeping every line, comment, order and unknown key (spec/gorizont.md, section 1).
/// Pure: reads and writes bytes, opens no file. Sections and keys ignore case; of a key given twice the first counts;
/// a section given twice is one section. `SCRCErr`, `SCRCErrors` and `SCRCError` are one key.
class IniFile
{
public:
    using Encoding = TextEncoding;

    struct Entry
    {
        QString section; ///< as written
        QString key; ///< as written
        QString value; ///< without surrounding blanks, otherwise as written (no inline comments)
        int line = 0; ///< 1…
    };

    /// A new, empty file; it is written in Windows-1251 so that the original program reads it.
    IniFile() = default;

    /// BOM → UTF-8 or UTF-16; else valid UTF-8 → UTF-8; else Windows-1251. Anything is accepted, a binary file too.
    /// No bytes make a new file.
    static IniFile fromBytes(const QByteArray &bytes);
    /// In the encoding and with the line ends it was read in. Every line that was not changed gives the same bytes.
    QByteArray toBytes() const;

    Encoding encoding() const { return m_encoding; }
    bool hasSection(const QString &section) const;
    QStringList sections() const; ///< in the order of the file, as written, each once
    QList<Entry> entries() const { return m_entries; } ///< in the order of the file, duplicates included
    QList<Entry> entries(const QString &section) const; ///< in the order of the file, each key once
    int sectionLine(const QString &section) const; ///< 0: no such section

    /// What does not count because it stood before: a header (then without key), or a key under the same header. Keys
    /// under a repeated header are not listed again.
    QList<Entry> repetitions() const { return m_repetitions; }

    std::optional<Entry> find(const QString &section, const QString &key) const;

    /// The encoding of the file has all characters of \a value. Others are written as `?`.
    bool canHold(const QString &value) const;

    /// Changes the value where the key stands, or adds the key at the end of its section, or the section at the end.
    /// Line breaks in \a value become blanks.
    void setValue(const QString &section, const QString &key, const QString &value);

private:
    struct Section
    {
        QString name; ///< as written
        int line = 0;
        int lastLine = 0; ///< the last one with a key under the first header, or the header; new keys go behind it
        QHash<QString, qsizetype> entryOfKey; ///< folded key → index into m_entries
    };

    /// Where the parser stands.
    struct Place
    {
        qsizetype section = -1; ///< index into m_sections; −1: before the first header and the first key
        bool isRepeated = false; ///< under a header that stood before
    };

    void parse();
    Place enterSection(const QString &name, int line);
    void addEntry(const Place &place, const Entry &entry);
    const Section *section(const QString &name) const;
    void replaceValue(const Entry &entry, const QString &key, const QString &value);
    void insertLines(qsizetype at, const QStringList &texts);

    Encoding m_encoding = Encoding::Windows1251;
    QByteArrayList m_lines; ///< as read, each with its line end
    QList<Entry> m_entries;
    QList<Entry> m_repetitions;
    QList<Section> m_sections; ///< the keys before the first header stand in a section without name
    QHash<QString, qsizetype> m_sectionOfName; ///< folded name → index into m_sections
};

} // namespace gorizont
