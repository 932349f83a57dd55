#include "app/tool/ind3text.h"

#include "app/tool/output.h"
#include "app/tool/text.h"

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace ind3;

QString dialectName(Dialect dialect)
{
    switch (dialect) {
    case Dialect::V211: return u"2.11"_s;
    case Dialect::V210: return u"2.10"_s;
    case Dialect::Modbus: return u"modbus"_s;
    }
    return {};
}

/// How the sensor's own test ended, in the words of the document.
QString selfTestText(SelfTest test)
{
    switch (test) {
    case SelfTest::ProgramChecksum: return Text::tr("wrong check sum of the program");
    case SelfTest::SettingsChecksum: return Text::tr("wrong check sum of the settings");
    case SelfTest::BothChecksums: return Text::tr("wrong check sums of program and settings");
    }
    return {};
}

QString offsetX(const Settings &settings)
{
    return settings.offset ? fixed(settings.offset->x, 3) : none;
}

QString offsetY(const Settings &settings)
{
    return settings.offset ? fixed(settings.offset->y, 3) : none;
}

} // namespace

void insertSettings(QJsonObject &object, const Settings &settings, Dialect dialect)
{
    insertNulls(object, {u"version"_s, u"name"_s, u"offsetX"_s, u"offsetY"_s, u"selfTest"_s});
    object.insert(u"protocol"_s, dialectName(dialect));
    if (!settings.version.isEmpty()) {
        object.insert(u"version"_s, settings.version);
    }
    object.insert(u"revision"_s, settings.revision.number);
    object.insert(u"serial"_s, static_cast<qint64>(settings.serialNumber));
    object.insert(u"baud"_s, settings.baud);
    object.insert(u"ticks"_s, settings.ticks);
    object.insert(u"period"_s, static_cast<int>(settings.period.count()));
    if (settings.name) {
        object.insert(u"name"_s, *settings.name);
    }
    if (settings.offset) {
        object.insert(u"offsetX"_s, settings.offset->x);
        object.insert(u"offsetY"_s, settings.offset->y);
    }
    if (settings.selfTest) {
        object.insert(u"selfTest"_s, static_cast<int>(*settings.selfTest));
    }
}

QString textOf(const Settings &settings)
{
    QStringList lines{
        Text::tr("Address: %1").arg(settings.address),
        Text::tr("Name: %1").arg(settings.name.value_or(none)),
        Text::tr("Speed: %1").arg(settings.baud),
        Text::tr("Version: %1").arg(settings.version.isEmpty() ? none : settings.version),
        Text::tr("Software revision: %1 (type %2, revision %3)")
            .arg(settings.revision.number)
            .arg(settings.revision.type())
            .arg(settings.revision.revision()),
        Text::tr("Serial number: %1").arg(settings.serialNumber),
        Text::tr("Zero offset X: %1″").arg(offsetX(settings)),
        Text::tr("Zero offset Y: %1″").arg(offsetY(settings)),
        Text::tr("Averaging ticks: %1").arg(settings.ticks),
        Text::tr("Averaging period: %1 ms").arg(settings.period.count())};
    if (settings.selfTest) {
        lines.append(Text::tr("Self-test: %1").arg(selfTestText(*settings.selfTest)));
    }
    return lines.join(u'\n');
}

QString lineOf(const Settings &settings)
{
    return u"%1  %2  %3  %4"_s.arg(settings.address, 3)
        .arg(settings.name.value_or(none), -static_cast<int>(longestName))
        .arg(Text::tr("No. %1").arg(settings.serialNumber), -10)
        .arg(settings.version.isEmpty() ? none : settings.version);
}

} // namespace gorizont::tool
