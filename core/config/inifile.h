#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

#include <optional>

namespace gorizont {

/// Text of an ini file ⇄ sections, keeping every line, comment, order and unknown key (spec/gorizont.md, section 1).
/// Pure: reads and writes bytes, opens no file. Sections and keys ignore case; of a key given twice the first counts.
class IniFile
{
public:
    enum class Encoding : quint8 { Utf8, Utf8Bom, Utf16Le, Utf16Be, Windows1251 };

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
    static IniFile fromBytes(const QByteArray &bytes);
    /// In the encoding and with the line ends it was read in. Unchanged content gives the same bytes.
    QByteArray toBytes() const;

    Encoding encoding() const { return m_encoding; }
    bool hasSection(const QString &section) const;
    QStringList sections() const; ///< in the order of the file, as written, each once
    QList<Entry> entries() const; ///< all of them in the order of the file, duplicates included
    int sectionLine(const QString &section) const; ///< 0: no such section

    std::optional<Entry> find(const QString &section, const QString &key) const;

    /// Changes the value where the key stands, or adds the key at the end of its section, or the section at the end.
    void setValue(const QString &section, const QString &key, const QString &value);

private:
    Encoding m_encoding = Encoding::Windows1251;
    QStringList m_lines; ///< without line ends
    QStringList m_ends; ///< the line end of each, as read
};

} // namespace gorizont
