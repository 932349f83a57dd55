#include "app/tool/ind3commands.h"

#include "app/tool/ind3text.h"
#include "app/tool/output.h"
#include "app/tool/readcommand.h"
#include "app/tool/scancommand.h"
#include "app/tool/text.h"

#include <QTime>

namespace gorizont::tool::ind3commands {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace ind3;

Service serviceOf(const Session &session)
{
    return {session.options().timing, session.options().dialect};
}

QJsonObject objectOf(const Session &session, const Settings &settings)
{
    QJsonObject object = session.object(settings.address);
    insertSettings(object, settings, session.options().dialect);
    return object;
}

void showFound(const Session &session, int address)
{
    if (session.options().dialect == Dialect::V210) { // it tells nothing about itself
        session.tell(u"%1"_s.arg(address, 3), session.object(address));
        return;
    }
    const auto settings = serviceOf(session).read(session.line(), address);
    if (settings) {
        session.tell(lineOf(*settings), objectOf(session, *settings));
    } else {
        showUnreadable(session, address, settings.fault());
    }
}

QString settingKey(Setting setting)
{
    switch (setting) {
    case Setting::Name: return u"name"_s;
    case Setting::Offset: return u"offset"_s;
    case Setting::Ticks: return u"ticks"_s;
    case Setting::Period: return u"period"_s;
    }
    return {};
}

QString settingTitle(Setting setting)
{
    switch (setting) {
    case Setting::Name: return Text::tr("name");
    case Setting::Offset: return Text::tr("zero offset");
    case Setting::Ticks: return Text::tr("averaging ticks");
    case Setting::Period: return Text::tr("averaging period");
    }
    return {};
}

ExitCode report(const Session &session, const Outcome &outcome)
{
    const QString title = settingTitle(outcome.setting);
    const QJsonObject object = session.outcome(settingKey(outcome.setting), static_cast<bool>(outcome.written));
    if (outcome.written) {
        session.tell(Text::tr("%1: written and read back").arg(title), object);
        return ExitGood;
    }
    const Fault fault = outcome.written.fault();
    if (fault == Fault::BadReply) {
        session.fail(fault, Text::tr("%1: the sensor has not taken the new value").arg(title), object);
        return ExitRefused;
    }
    return session.fail(fault, Text::tr("%1: not written (%2)").arg(title, faultText(fault)), object);
}

ExitCode write(const Session &session, const Changes &changes, const QString &question)
{
    if (!session.isAgreed(question)) {
        return session.fail(
            Fault::Cancelled, Text::tr("nothing was written"), session.object(session.options().address));
    }
    ExitCode code = ExitGood;
    const auto outcomes = serviceOf(session).write(session.line(), session.options().address, changes);
    for (const Outcome &outcome : outcomes) {
        code = std::max(code, report(session, outcome));
    }
    return code;
}

/// A sentence for each way in which a change of address fails.
QString addressSentence(Fault fault, int address, int newAddress)
{
    switch (fault) {
    case Fault::Refused:
        return Text::tr("address %1 is taken, or the sensor refuses it; nothing was changed").arg(newAddress);
    case Fault::BadReply: return Text::tr("the sensor still answers at address %1").arg(address);
    case Fault::Timeout:
        return Text::tr("no answer, neither at address %1 nor at %2; scan the line").arg(address).arg(newAddress);
    default: return Text::tr("what became of the address is not known (%1); scan the line").arg(faultText(fault));
    }
}

} // namespace

ExitCode scan(Session &session)
{
    const Service service = serviceOf(session);
    return scanLine(
        session,
        {[&](int address) { return service.probe(session.line(), address); },
         [&](int address) { showFound(session, address); }});
}

ExitCode read(Session &session)
{
    const Service service = serviceOf(session);
    return readRepeatedly(session, [&](QJsonObject &object) -> Result<QString> {
        const auto tilt = service.readTilt(session.line(), session.options().address);
        if (!tilt) {
            return tilt.fault();
        }
        object.insert(u"tiltX"_s, tilt->x);
        object.insert(u"tiltY"_s, tilt->y);
        return u"%1  X %2″  Y %3″"_s.arg(
            QTime::currentTime().toString(u"hh:mm:ss"), fixed(tilt->x, 3), fixed(tilt->y, 3));
    });
}

ExitCode info(Session &session)
{
    const auto settings = serviceOf(session).read(session.line(), session.options().address);
    if (!settings) {
        return session.fail(settings.fault(), session.options().address);
    }
    session.tell(textOf(*settings), objectOf(session, *settings));
    return ExitGood;
}

ExitCode setAddress(Session &session)
{
    const int address = session.options().address;
    const int newAddress = session.options().newAddress;
    if (!session.isAgreed(Text::tr("Give the sensor with address %1 the address %2?").arg(address).arg(newAddress))) {
        return session.fail(Fault::Cancelled, Text::tr("nothing was written"), session.object(address));
    }
    const auto changed = serviceOf(session).changeAddress(session.line(), address, newAddress);
    QJsonObject object = session.outcome(u"address"_s, static_cast<bool>(changed));
    object.insert(u"newAddress"_s, newAddress);
    if (changed) {
        session.tell(Text::tr("The sensor now answers at address %1.").arg(newAddress), object);
        return ExitGood;
    }
    const Fault fault = changed.fault();
    const ExitCode code = session.fail(fault, addressSentence(fault, address, newAddress), object);
    return fault == Fault::BadReply ? ExitRefused : code;
}

ExitCode setName(Session &session)
{
    const Options &options = session.options();
    return write(
        session, {.name = options.name, .offset = {}, .ticks = {}, .period = {}},
        Text::tr("Write the name \"%1\" to the sensor with address %2?").arg(options.name).arg(options.address));
}

ExitCode setOffset(Session &session)
{
    const Options &options = session.options();
    return write(
        session, {.name = {}, .offset = options.offset, .ticks = {}, .period = {}},
        Text::tr("Write the zero offset X %1″, Y %2″ to the sensor with address %3?")
            .arg(fixed(options.offset.x, 3), fixed(options.offset.y, 3))
            .arg(options.address));
}

ExitCode setAveraging(Session &session)
{
    const Options &options = session.options();
    QStringList parts;
    if (options.ticks) {
        parts.append(Text::tr("ticks: %1").arg(*options.ticks));
    }
    if (options.period) {
        parts.append(Text::tr("period: %1 ms").arg(options.period->count()));
    }
    return write(
        session, {.name = {}, .offset = {}, .ticks = options.ticks, .period = options.period},
        Text::tr("Write the averaging (%1) to the sensor with address %2?")
            .arg(parts.join(u", "_s))
            .arg(options.address));
}

} // namespace gorizont::tool::ind3commands
