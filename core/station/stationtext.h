#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

#include <optional>

namespace gorizont::station {

/// The text of a parameter file. A BOM or valid UTF-8: UTF-8. Else letters decide between the two encodings of one byte: the
/// bytes 80h…AFh are most letters of CP866 and hardly any of Windows-1251, C0h…DFh and F0h…FFh the other way round; more of the
/// first: CP866. A lone F8h is the degree sign of CP866. None or as many: Windows-1251.
QString decodeStationText(const QByteArray &bytes);

/// One field of a line.
struct Field
{
    QString text; ///< without its quotes
    bool isQuoted = false;
    /// A bare dash, "none".
    bool isNone() const;
    bool operator==(const Field &) const = default;
};

/// A line with at least one field.
struct Record
{
    int line = 0; ///< 1…
    QList<Field> fields;
    qsizetype firstField = 0; ///< how many fields of the line stand before these
    bool isQuoteOpen = false; ///< a double quote without its partner: the last field reaches to the end of the line
    bool operator==(const Record &) const = default;
};

/// The lines of \a text that hold anything. Blanks and tabs separate fields, double quotes hold a text together, `;` outside of
/// them begins a comment.
QList<Record> recordsOf(const QString &text);

/// The Latin letter that looks like \a letter when it is Cyrillic (А, В, Е, К, М, Н, О, Р, С, Т, У, Х and the small ones that
/// look alike), else \a letter itself.
QChar latinised(QChar letter);
QString latinised(QString text);

/// A number with a decimal point or comma. Empty: it is none, or not finite.
std::optional<double> numberOf(QStringView text);

} // namespace gorizont::station
