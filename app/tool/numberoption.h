#pragma once

#include "app/tool/text.h"

#include <QCommandLineParser>

namespace gorizont::tool {

/// "--period takes 1…9, not \"x\"".
inline QString outOfRange(const QString &option, int least, int most, const QString &text)
{
    return Text::tr("--%1 takes %2, not \"%3\"").arg(option, QStringLiteral("%1…%2").arg(least).arg(most), text);
}

/// Leaves \a value alone if \a option is not there. What is wrong, as a sentence; empty: nothing.
template <typename T>
QString readNumber(const QCommandLineParser &parser, const QString &option, int least, int most, T &value)
{
    if (!parser.isSet(option)) {
        return {};
    }
    bool isNumber = false;
    const int number = parser.value(option).toInt(&isNumber);
    if (!isNumber || number < least || number > most) {
        return outOfRange(option, least, most, parser.value(option));
    }
    value = T(number);
    return {};
}

} // namespace gorizont::tool
