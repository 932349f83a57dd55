#include "app/tool/usmoptions.h"

#include "app/tool/numberoption.h"
#include "app/tool/text.h"

#include <QCommandLineParser>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using std::chrono::seconds;

QString readMask(const QCommandLineParser &parser, UsmOptions &options)
{
    const QString mask = parser.value(u"mask"_s).toUpper();
    if (parser.isSet(u"mask"_s) && mask != u"ALL" && mask != u"NEW") {
        return Text::tr("--%1 takes %2, not \"%3\"").arg(u"mask"_s, u"ALL, NEW"_s, parser.value(u"mask"_s));
    }
    options.mask = mask == u"NEW" ? usmisn::RecordMask::New : usmisn::RecordMask::All;
    return {};
}

QString readNewAddress(const QString &text, UsmOptions &options)
{
    bool isNumber = false;
    options.newAddress = text.toInt(&isNumber);
    return isNumber && usmisn::isAddress(options.newAddress) ? QString()
                                                             : Text::tr("an address is 1…255, not \"%1\"").arg(text);
}

QString readPort(const QStringList &arguments, UsmOptions &options)
{
    bool isNumber = false;
    options.port.baudRate = arguments.at(0).toInt(&isNumber);
    const qsizetype parity = QStringList{u"N"_s, u"E"_s, u"O"_s}.indexOf(arguments.at(1).toUpper());
    const qsizetype stopBits = QStringList{u"1"_s, u"1.5"_s, u"2"_s}.indexOf(arguments.at(2));
    options.port.parity = static_cast<Parity>(std::max<qsizetype>(parity, 0));
    options.port.stopBits = static_cast<StopBits>(std::max<qsizetype>(stopBits, 0));
    return isNumber && parity >= 0 && stopBits >= 0 && usmisn::isPossible(options.port)
        ? QString()
        : Text::tr("port settings are 110…115200, N or E or O, 1 or 1.5 or 2, not \"%1\"").arg(arguments.join(u' '));
}

QString readSerial(const QString &text, UsmOptions &options)
{
    bool isNumber = false;
    options.serial = text.toUInt(&isNumber);
    return isNumber && options.serial > 0 && options.serial <= 99'999'999
        ? QString()
        : Text::tr("a serial number has up to eight digits, not \"%1\"").arg(text);
}

} // namespace

QString readUsmOptions(
    const QCommandLineParser &parser, const QString &name, const QStringList &arguments, UsmOptions &options)
{
    QStringList problems{
        readNumber(parser, u"channel"_s, 1, 2, options.channel), readMask(parser, options),
        readNumber(parser, u"start-in"_s, 1, 31'536'000, options.startIn),
        readNumber(parser, u"delay"_s, 0, int(usmisn::longestDelay.count()), options.delay)};
    if (name == u"usm records") {
        problems.append(readNumber(parser, u"count"_s, 0, 999, options.count));
    } else if (name == u"usm start-cycle") {
        problems.append(readNumber(
            parser, u"period"_s, int(usmisn::shortestPeriod.count()), int(usmisn::longestPeriod.count()),
            options.period));
    } else if (name == u"usm set-address") {
        problems.append(readNewAddress(arguments.at(0), options));
    } else if (name == u"usm port-settings") {
        problems.append(readPort(arguments, options));
    } else if (name == u"usm find") {
        problems.append(readSerial(arguments.at(0), options));
    }
    options.csvFile = parser.value(u"csv"_s);
    if (parser.isSet(u"csv"_s) && options.csvFile.isEmpty()) {
        problems.append(Text::tr("--%1 takes %2, not \"%3\"").arg(u"csv"_s, u"FILE"_s, options.csvFile));
    }
    options.isStored = parser.isSet(u"store"_s);
    problems.removeAll(QString());
    return problems.isEmpty() ? QString() : problems.constFirst();
}

} // namespace gorizont::tool
