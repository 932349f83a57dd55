#include "core/devices/usmisn/usmisnservice.h"

namespace gorizont::usmisn {

namespace {

/// A lost answer may be better the next time; so may one that is not clear.
bool isOpenQuestion(const Result<void> &sent)
{
    return sent || isWorthAnother(sent.fault());
}

} // namespace

/// Whether somebody answers there.
Result<void> Service::isAt(Line &line, int address) const
{
    const auto type = withAttempts([&] { return askType(line, address); });
    return type ? Result<void>() : type.fault();
}

Result<void> Service::changeAddress(Line &line, int address, int newAddress) const
{
    if (!isAddress(address) || !isAddress(newAddress)) {
        return Fault::Refused;
    }
    const auto isTaken = isSomebodyThere([&]() -> Result<void> {
        const auto heard = probe(line, newAddress);
        return heard ? Result<void>() : heard.fault();
    });
    if (!isTaken || *isTaken) {
        return isTaken ? Fault::Refused : isTaken.fault();
    }
    const auto moved = withAttempts([&]() -> Result<void> {
        const auto sent = echoed(line, to(address).setAddress(newAddress));
        return isOpenQuestion(sent) ? isAt(line, newAddress) : sent;
    });
    if (moved || !isWorthAnother(moved.fault())) {
        return moved;
    }
    const auto isAtOld = isAt(line, address);
    if (isAtOld) {
        return Fault::BadReply;
    }
    return isLineFault(isAtOld.fault()) ? isAtOld : moved;
}

/// The answer comes at the old settings, as far as it is known; only who answers at the new ones is believed.
PortChange Service::movePort(Line &line, int address, const PortSettings &wanted, const std::optional<Ask> &ask) const
{
    if (!isAddress(address)) {
        return {Fault::Refused};
    }
    const auto sent = echoed(line, ask);
    if (!isOpenQuestion(sent)) {
        return {sent};
    }
    const auto current = line.port();
    if (!current) {
        return {sent};
    }
    if (const auto switched = line.setPort(wanted); !switched) {
        return {switched.fault() == Fault::Refused ? sent : switched};
    }
    const auto isAtNew = isAt(line, address);
    if (const auto back = line.setPort(*current); !back || isAtNew || isLineFault(isAtNew.fault())) {
        return {back ? isAtNew : back, true};
    }
    const auto isAtOld = isAt(line, address);
    if (isAtOld) {
        return {Fault::BadReply, true};
    }
    return {isLineFault(isAtOld.fault()) ? isAtOld : isAtNew, true};
}

PortChange Service::changePort(Line &line, int address, const PortSettings &wanted) const
{
    return movePort(line, address, wanted, to(address).setPortSettings(wanted));
}

PortChange Service::resetPort(Line &line, int address) const
{
    return movePort(line, address, factoryPort, to(address).plain(Instruction::ResetPortSettings));
}

/// A lost answer is no failure if a device that was there is silent then: it sleeps.
Result<void> Service::startCycle(Line &line, int address, const Recording &recording) const
{
    if (!isAddress(address) || !isPossible(recording)) {
        return Fault::Refused;
    }
    if (const auto isThere = isAt(line, address); !isThere) {
        return isThere;
    }
    return withAttempts([&]() -> Result<void> {
        const auto sent = echoed(line, to(address).startCycle(recording));
        if (sent || !isWorthAnother(sent.fault())) {
            return sent;
        }
        const auto awake = isAt(line, address);
        if (awake) {
            return sent;
        }
        return awake.fault() == Fault::Timeout ? Result<void>() : awake;
    });
}

Result<void> Service::tryStopCycle(Line &line, int address) const
{
    if (!isAddress(address)) {
        return Fault::Refused;
    }
    const Ask ask = to(address).plain(Instruction::StopCycle);
    const auto answer = exchange(line, ask, repeatStop);
    return answer ? decodeEcho(*answer, ask) : answer.fault();
}

Result<void> Service::setEveryAddress(Line &line, int newAddress) const
{
    return send(line, to(everybody).setAddress(newAddress));
}

Result<void> Service::setEveryPort(Line &line, const PortSettings &wanted) const
{
    return send(line, to(everybody).setPortSettings(wanted));
}

Result<void> Service::resetEveryPort(Line &line) const
{
    return send(line, to(everybody).plain(Instruction::ResetPortSettings));
}

Result<void> Service::startEveryCycle(Line &line, const Recording &recording) const
{
    return send(line, to(everybody).startCycle(recording));
}

Result<void> Service::stopEveryCycle(Line &line) const
{
    return send(line, to(everybody).plain(Instruction::StopCycle));
}

} // namespace gorizont::usmisn
