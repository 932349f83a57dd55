#pragma once

#include <QString>

namespace gorizont {

/// One line of an ini file taken apart (spec/gorizont.md, section 1). Positions count from the start of the line.
struct IniLine
{
    enum class Kind : quint8 {
        Ignored, ///< blank, a comment (`;`, `//`, `#`, `,*`), or without `=`
        Header, ///< `[name]`
        Entry, ///< `key=value`
    };

    Kind kind = Kind::Ignored;
    QString name; ///< of the section or of the key, without blanks around it
    qsizetype nameBegin = 0;
    QString value; ///< without blanks around it
    qsizetype valueBegin = 0;
};

/// \a text may end with its line end. A header that lost its `]` is still one, so that its keys do not fall to the
/// section before.
IniLine readIniLine(QStringView text);

/// CR LF, LF, CR or nothing.
QStringView lineEndOf(QStringView text);

/// The entry \a text with \a key and \a value in place of its own; blanks and line end stay.
QString withKeyAndValue(const QString &text, const QString &key, const QString &value);

} // namespace gorizont
