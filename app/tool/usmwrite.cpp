#include "app/tool/usmwrite.h"

#include "app/tool/session.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "core/devices/usmisn/usmisnservice.h"

#include <QDateTime>

namespace gorizont::tool::usmwrite {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace usmisn;

ExitCode refused(const Session &session)
{
    return session.fail(Fault::Cancelled, Text::tr("nothing was written"), session.object(session.options().address));
}

/// BadReply is a device that has not taken what it was told.
ExitCode codeOf(Fault fault, ExitCode code)
{
    return fault == Fault::BadReply ? ExitRefused : code;
}

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

QString portSentence(Fault fault)
{
    switch (fault) {
    case Fault::Refused: return Text::tr("the device refuses these port settings; nothing was changed");
    case Fault::BadReply: return Text::tr("the device still answers at the old port settings");
    case Fault::Timeout:
        return Text::tr("no answer, neither at the old nor at the new port settings; switch the device off and on, it "
                        "listens at 9600-N-1 for its first second");
    default: return Text::tr("what became of the port settings is not known (%1)").arg(faultText(fault));
    }
}

} // namespace

ExitCode startCycle(Session &session)
{
    const int address = session.options().address;
    const UsmOptions &usm = session.options().usm;
    if (!session.isAgreed(Text::tr("Make the device with address %1 a recorder, every %2 s? It sleeps until "
                                   "stop-cycle, or until it is without power for over a minute.")
                              .arg(address)
                              .arg(usm.period.count()))) {
        return refused(session);
    }
    const qint64 now = QDateTime::currentSecsSinceEpoch();
    const Recording recording{now, now + usm.startIn.count(), usm.period, usm.delay};
    const auto started = Service(session.options().timing).startCycle(session.line(), address, recording);
    if (!started) {
        return codeOf(started.fault(), session.fail(started.fault(), address));
    }
    session.tell(Text::tr("The device records."), session.outcome(u"recorder"_s, true));
    return ExitGood;
}

/// It listens for one second in 26, so it is asked again and again.
ExitCode stopCycle(Session &session)
{
    const int address = session.options().address;
    const Service service(session.options().timing);
    const auto start = std::chrono::steady_clock::now();
    Result<void> stopped = Fault::Timeout;
    while (!stopped && isWorthAnother(stopped.fault())) {
        const auto passed = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start);
        if (passed >= Service::stopLimit) {
            break;
        }
        showProgress(Text::tr("waiting for the recorder to wake, %1 s…").arg(passed.count()));
        stopped = service.tryStopCycle(session.line(), address);
    }
    if (!stopped) {
        return session.fail(stopped.fault(), address);
    }
    session.tell(Text::tr("The device does not record any more."), session.outcome(u"recorder"_s, true));
    return ExitGood;
}

ExitCode setAddress(Session &session)
{
    const int address = session.options().address;
    const int newAddress = session.options().usm.newAddress;
    if (!session.isAgreed(Text::tr("Give the sensor with address %1 the address %2?").arg(address).arg(newAddress))) {
        return refused(session);
    }
    const auto changed = Service(session.options().timing).changeAddress(session.line(), address, newAddress);
    QJsonObject object = session.outcome(u"address"_s, static_cast<bool>(changed));
    object.insert(u"newAddress"_s, newAddress);
    if (!changed) {
        const Fault fault = changed.fault();
        return codeOf(fault, session.fail(fault, addressSentence(fault, address, newAddress), object));
    }
    session.tell(Text::tr("The sensor now answers at address %1.").arg(newAddress), object);
    return ExitGood;
}

ExitCode portSettings(Session &session)
{
    const int address = session.options().address;
    if (!session.isAgreed(Text::tr("Give the device with address %1 other port settings?").arg(address))) {
        return refused(session);
    }
    const PortChange change =
        Service(session.options().timing).changePort(session.line(), address, session.options().usm.port);
    QJsonObject object = session.outcome(u"port"_s, static_cast<bool>(change.result));
    object.insert(u"isProbed"_s, change.isProbed);
    if (!change.result) {
        const Fault fault = change.result.fault();
        return codeOf(fault, session.fail(fault, portSentence(fault), object));
    }
    session.tell(
        change.isProbed ? Text::tr("The device answers at its new port settings.")
                        : Text::tr("The device has taken its new port settings; this line cannot try them."),
        object);
    return ExitGood;
}

} // namespace gorizont::tool::usmwrite
