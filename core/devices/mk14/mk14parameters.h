#pragma once

#include <QByteArray>
#include <QChar>
#include <QList>
#include <QString>

#include <optional>

namespace gorizont::mk14 {

/// What is known of one parameter of a station beside its values.
struct ParameterName
{
    QChar code; ///< U, T, P, H, A, M, …
    int number = 1; ///< among those of the same code
    QString name; ///< empty: not known
    QString unit; ///< empty: not known
    bool operator==(const ParameterName &) const = default;
};

/// U, T, P, H, A, M: the example of manual 004, section 4.2.
QList<ParameterName> usualParameters();

/// A list like `U,T,T,P` or `U, T1, T2`: codes with or without a number, parted by commas or blanks; the second of a code without
/// one is number 2. Names and units are those of the usual codes. Empty: it is no such list.
std::optional<QList<ParameterName>> parametersInList(const QString &text);

/// What an ACK.PAR file says (manual 004, section 3.2; spec/mk14.md, "Files of the station"), in the order of its lines.
struct ParameterFile
{
    QList<ParameterName> parameters;
    QList<int> badLines; ///< 1…: neither comment nor parameter; left out
};

constexpr qint64 longestParameterFile = 1024 * 1024; ///< bytes; what is behind them is not read

/// \a bytes in UTF-8, Windows-1251 or CP866.
ParameterFile parametersInFile(const QByteArray &bytes);

} // namespace gorizont::mk14
