#include "app/tool/usmcommands.h"

#include "app/tool/output.h"
#include "app/tool/recordtable.h"
#include "app/tool/scancommand.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "app/tool/usmtext.h"
#include "app/tool/usmwrite.h"
#include "core/devices/usmisn/usmisnfetch.h"
#include "core/devices/usmisn/usmisnrecords.h"
#include "core/devices/usmisn/usmisnservice.h"

#include <QDateTime>

namespace gorizont::tool::usmcommands {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace usmisn;

Service serviceOf(const Session &session)
{
    return Service(session.options().timing);
}

ExitCode scan(Session &session)
{
    const Service service = serviceOf(session);
    const auto show = [&](int address) {
        const auto identity = service.read(session.line(), address);
        if (!identity) {
            return showUnreadable(session, address, identity.fault());
        }
        QJsonObject object = session.object(address);
        insertIdentity(object, *identity);
        session.tell(lineOf(*identity), object);
    };
    const auto probe = [&](int address) {
        const auto type = service.probe(session.line(), address);
        return type ? Result<void>() : Result<void>(type.fault());
    };
    return scanLine(session, {probe, show});
}

ExitCode find(Session &session)
{
    const quint32 serial = session.options().usm.serial;
    const auto address = serviceOf(session).find(session.line(), serial);
    QJsonObject object = session.object(address ? *address : everybody);
    object.insert(u"serial"_s, qint64(serial));
    if (address) {
        session.tell(Text::tr("The device %1 has the address %2.").arg(serial).arg(*address), object);
        return ExitGood;
    }
    return session.fail(
        address.fault(), Text::tr("the device %1 does not answer (%2)").arg(serial).arg(faultText(address.fault())),
        object);
}

ExitCode info(Session &session)
{
    const auto identity = serviceOf(session).read(session.line(), session.options().address);
    if (!identity) {
        return session.fail(identity.fault(), session.options().address);
    }
    QJsonObject object = session.object(identity->address);
    insertIdentity(object, *identity);
    session.tell(textOf(*identity), object);
    return ExitGood;
}

ExitCode serial(Session &session)
{
    const auto serial = serviceOf(session).serial(session.line(), session.options().address);
    if (!serial) {
        return session.fail(serial.fault(), session.options().address);
    }
    QJsonObject object = session.object(session.options().address);
    object.insert(u"serial"_s, qint64(*serial));
    session.tell(serialText(*serial), object);
    return ExitGood;
}

QList<int> wantedChannels(const Session &session)
{
    const int channel = session.options().usm.channel;
    return channel == 0 ? QList<int>{channelX, channelY} : QList<int>{channel};
}

ExitCode tellValue(const Session &session, const Value &value)
{
    QJsonObject object = session.object(session.options().address);
    insertValue(object, value);
    if (value.state == ValueState::ErrorChannel || value.state == ValueState::ErrorData) {
        return session.fail(Fault::Refused, session.options().address);
    }
    session.tell(lineOf(value), object);
    return value.state == ValueState::ErrorSensor ? ExitRefused : ExitGood;
}

ExitCode value(Session &session)
{
    const Service service = serviceOf(session);
    ExitCode code = ExitGood;
    for (const int channel : wantedChannels(session)) {
        const qint64 timestamp = session.options().usm.isStored ? QDateTime::currentSecsSinceEpoch() : 0;
        const auto value = service.measure(session.line(), session.options().address, channel, timestamp);
        code =
            std::max(code, value ? tellValue(session, *value) : session.fail(value.fault(), session.options().address));
        if (!value && isLineFault(value.fault())) {
            break;
        }
    }
    return code;
}

/// What New has marked as read and lost on the way is asked for again with All. Empty: a record could not be written.
std::optional<Result<void>> fetch(Session &session, RecordBook &book, RecordTable &table)
{
    const Service service = serviceOf(session);
    const UsmOptions &usm = session.options().usm;
    bool isWritten = true;
    RecordFetch fetch(usm.mask, wantedChannels(session));
    while (!fetch.isOver()) {
        fetch.record(service.records(
            session.line(), session.options().address, usm.count, fetch.mask(), fetch.channel(),
            [&](const Value &record) {
                if (book.add(record)) {
                    isWritten = !table.isOpen() || table.add(record);
                    tellValue(session, record);
                    showProgress(Text::tr("%n record(s)", nullptr, static_cast<int>(book.size())));
                }
                return isWritten;
            }));
    }
    return isWritten ? std::optional(fetch.result()) : std::nullopt;
}

ExitCode records(Session &session)
{
    RecordBook book;
    RecordTable table;
    const int address = session.options().address;
    if (const QString file = session.options().usm.csvFile; !file.isEmpty()) {
        if (const QString problem = table.open(file); !problem.isEmpty()) {
            return session.fail(Fault::Refused, problem, session.object(address));
        }
    }
    const auto done = fetch(session, book, table);
    showProgress({});
    if (!done) {
        return session.fail(Fault::Refused, table.error(), session.object(address));
    }
    if (!*done) {
        return session.fail(done->fault(), address);
    }
    if (!session.options().isJson) {
        complain(
            Text::tr("%n record(s)", nullptr, static_cast<int>(book.size())) + u"; "_s
            + Text::tr("%n measurement(s) missing", nullptr, static_cast<int>(book.missing())));
    }
    return ExitGood;
}

} // namespace

QList<Command> table()
{
    return {
        {.name = u"usm scan"_s,
         .options = {u"from"_s, u"to"_s},
         .needsAddress = false,
         .runUsm = scan,
         .description = Text::tr("УСМ-ИСН: looks for devices at the addresses 1…255")},
        {.name = u"usm find"_s,
         .arguments = u"SERIAL"_s,
         .needsAddress = false,
         .runUsm = find,
         .description = Text::tr("looks for the device with this serial number")},
        {.name = u"usm serial"_s, .runUsm = serial, .description = Text::tr("prints the serial number")},
        {.name = u"usm info"_s,
         .runUsm = info,
         .description = Text::tr("prints what the device is, its calibration and channels")},
        {.name = u"usm value"_s,
         .options = {u"channel"_s, u"store"_s},
         .runUsm = value,
         .description = Text::tr("measures now, about 1.5 s a channel")},
        {.name = u"usm records"_s,
         .options = {u"channel"_s, u"mask"_s, u"count"_s, u"csv"_s},
         .runUsm = records,
         .description = Text::tr("prints the records of the device; up to some minutes at 9600")},
        {.name = u"usm start-cycle"_s,
         .options = {u"period"_s, u"delay"_s, u"start-in"_s},
         .writes = true,
         .runUsm = usmwrite::startCycle,
         .description = Text::tr("makes it a recorder, which sleeps and does not answer any more")},
        {.name = u"usm stop-cycle"_s,
         .runUsm = usmwrite::stopCycle,
         .description = Text::tr("wakes a recorder, up to two minutes")},
        {.name = u"usm set-address"_s,
         .arguments = u"NEW"_s,
         .writes = true,
         .runUsm = usmwrite::setAddress,
         .description = Text::tr("gives the device another address")},
        {.name = u"usm port-settings"_s,
         .arguments = u"BAUD PARITY STOPBITS"_s,
         .writes = true,
         .runUsm = usmwrite::portSettings,
         .description = Text::tr("gives the device another speed, N|E|O, 1|1.5|2, and looks whether it answers there")},
    };
}

} // namespace gorizont::tool::usmcommands
