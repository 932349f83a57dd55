#include "app/tool/and3commands.h"

#include "app/tool/and3text.h"
#include "app/tool/readcommand.h"
#include "app/tool/scancommand.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"

#include <QTime>

namespace gorizont::tool::and3commands {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace std::chrono_literals;
using namespace and3;

/// After the time of a restart, how often the sensor is looked for, a second apart.
constexpr int mostLooks = 5;

Service serviceOf(const Session &session)
{
    return Service(session.options().timing);
}

QJsonObject objectOf(const Session &session, const Settings &settings)
{
    QJsonObject object = session.object(settings.address);
    insertSettings(object, settings);
    return object;
}

void showFound(const Session &session, int address)
{
    const auto settings = serviceOf(session).read(session.line(), address);
    if (settings) {
        session.tell(lineOf(*settings), objectOf(session, *settings));
    } else {
        showUnreadable(session, address, settings.fault());
    }
}

/// Where the change stopped, and what that means for the sensor.
QString addressSentence(const AddressChange &change, int newAddress)
{
    const QString fault = faultText(change.result.fault());
    switch (change.step) {
    case AddressStep::Probe:
        return change.result.fault() == Fault::Refused
            ? Text::tr("address %1 is taken; nothing was changed").arg(newAddress)
            : Text::tr("nothing was changed (%1)").arg(fault);
    case AddressStep::Check:
    case AddressStep::Verify:
        if (change.result.fault() == Fault::BadReply) {
            return Text::tr("the configuration of the sensor is not as expected; nothing was stored");
        }
        [[fallthrough]];
    case AddressStep::Copy:
    case AddressStep::Set: return Text::tr("nothing was stored (%1)").arg(fault);
    case AddressStep::Store:
    case AddressStep::VerifyStored:
        return Text::tr("whether the new address was stored is not known (%1); the old one holds until a restart")
            .arg(fault);
    case AddressStep::Done: break;
    }
    return {};
}

/// Restarts the sensor and waits until it answers at \a newAddress.
Result<void> restart(const Session &session, int address, int newAddress)
{
    const Service service = serviceOf(session);
    if (const auto told = service.reset(session.line(), address); !told) {
        return told;
    }
    showProgress(Text::tr("the sensor restarts, about %1 s…").arg(Service::restartTime.count()));
    Result<void> heard = Fault::Timeout;
    bool isAwaited = session.wait(Service::restartTime);
    for (int i = 0; i < mostLooks && isAwaited && !heard; ++i) {
        isAwaited = i == 0 || session.wait(1s);
        heard = service.probe(session.line(), newAddress);
    }
    return isAwaited ? heard : Fault::Cancelled;
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
        const auto got = service.readValues(session.line(), session.options().address);
        if (!got) {
            return got.fault();
        }
        insertValues(object, *got);
        return u"%1  %2"_s.arg(QTime::currentTime().toString(u"hh:mm:ss"), lineOf(*got));
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
    if (!session.isAgreed(
            Text::tr("Store the address %2 in the sensor with address %1?").arg(address).arg(newAddress))) {
        return session.fail(Fault::Cancelled, Text::tr("nothing was written"), session.object(address));
    }
    const AddressChange change = serviceOf(session).storeAddress(session.line(), address, newAddress);
    QJsonObject object = session.outcome(u"address"_s, false);
    object.insert(u"newAddress"_s, newAddress);
    if (!change.result) {
        const ExitCode code = session.fail(change.result.fault(), addressSentence(change, newAddress), object);
        return change.result.fault() == Fault::BadReply ? ExitRefused : code;
    }
    if (!session.isAgreed(Text::tr("The address is stored. Restart the sensor, so that it holds?"))) {
        return session.fail(
            Fault::Cancelled, Text::tr("the new address is stored and holds after the next restart"), object);
    }
    if (const auto done = restart(session, address, newAddress); !done) {
        return session.fail(
            done.fault(),
            Text::tr("the new address is stored, but the sensor does not answer there (%1); scan the line")
                .arg(faultText(done.fault())),
            object);
    }
    object.insert(u"done"_s, true);
    session.tell(Text::tr("The sensor now answers at address %1.").arg(newAddress), object);
    return ExitGood;
}

ExitCode reset(Session &session)
{
    const int address = session.options().address;
    if (!session.isAgreed(Text::tr("Restart the sensor with address %1?").arg(address))) {
        return session.fail(Fault::Cancelled, Text::tr("nothing was done"), session.object(address));
    }
    const auto done = restart(session, address, address);
    const QJsonObject object = session.outcome(u"reset"_s, static_cast<bool>(done));
    if (!done) {
        return session.fail(
            done.fault(), Text::tr("the sensor does not answer (%1)").arg(faultText(done.fault())), object);
    }
    session.tell(Text::tr("The sensor has restarted and answers."), object);
    return ExitGood;
}

} // namespace gorizont::tool::and3commands
