#include "core/export/seedcodes.h"

#include <QHash>

#include <algorithm>

namespace gorizont {

namespace {

constexpr int letters = 26;

bool isCodeCharacter(QChar c)
{
    return (c >= u'A' && c <= u'Z') || (c >= u'0' && c <= u'9');
}

bool isCode(const QString &text, qsizetype least, qsizetype most)
{
    return text.size() >= least && text.size() <= most && std::all_of(text.begin(), text.end(), isCodeCharacter);
}

QString inLatin(QChar russian)
{
    static const QHash<char16_t, QString> table = [] {
        const QString from = QStringLiteral("АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ");
        const QStringList to =
            QStringLiteral("A B V G D E E ZH Z I Y K L M N O P R S T U F KH TS CH SH SCH _ Y _ E YU YA").split(u' ');
        QHash<char16_t, QString> result;
        for (qsizetype i = 0; i < from.size(); ++i) {
            result.insert(from.at(i).unicode(), to.at(i) == u"_" ? QString() : to.at(i));
        }
        return result;
    }();
    return table.value(russian.unicode());
}

QChar letter(int index)
{
    return QChar(u'A' + index);
}

} // namespace

bool isValid(const SeedCodes &codes)
{
    return isCode(codes.network, 1, 2) && isCode(codes.station, 1, 5) && isCode(codes.channelX, 3, 3)
        && isCode(codes.channelY, 3, 3) && codes.channelX != codes.channelY;
}

QString seedStation(const QString &siteName)
{
    QString code;
    for (const QChar c : siteName.toUpper()) {
        code += isCodeCharacter(c) ? QString(c) : inLatin(c);
    }
    code.truncate(5);
    return code.isEmpty() ? QStringLiteral("SITE") : code;
}

QString seedLocation(int number)
{
    constexpr int firstMixed = 100;
    constexpr int firstLetters = firstMixed + letters * 10;
    if (number < 1 || number >= firstLetters + letters * letters) {
        return {};
    }
    if (number < firstMixed) {
        return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0'));
    }
    if (number < firstLetters) {
        const int index = number - firstMixed;
        return QString(letter(index / 10)) + QString::number(index % 10);
    }
    const int index = number - firstLetters;
    return QString(letter(index / letters)) + letter(index % letters);
}

} // namespace gorizont
