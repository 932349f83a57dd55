#include "core/devices/ind3/ind3modbus.h"
#include "core/devices/ind3/ind3service.h"

#include <cmath>

namespace gorizont::ind3 {

namespace {

/// What the sensor keeps of an offset that it was sent: 2.11 has 1/256″. The map of Modbus does not say in which unit
/// the sensor keeps its thousandths, so there the same step is granted.
constexpr double offsetStep = 1.0 / 256; ///< arc-seconds

template <typename T> bool areSame(const T &left, const T &right)
{
    return left == right;
}

bool areSame(const Tilt &left, const Tilt &right)
{
    return std::abs(left.x - right.x) < offsetStep && std::abs(left.y - right.y) < offsetStep;
}

/// BadReply: \a read is something else than \a wanted.
template <typename T> Result<void> isSame(const Result<T> &read, const T &wanted)
{
    if (!read) {
        return read.fault();
    }
    return areSame(*read, wanted) ? Result<void>() : Result<void>(Fault::BadReply);
}

bool has(const Changes &changes, Setting setting)
{
    switch (setting) {
    case Setting::Name: return changes.name.has_value();
    case Setting::Offset: return changes.offset.has_value();
    case Setting::Ticks: return changes.ticks.has_value();
    case Setting::Period: return changes.period.has_value();
    }
    return false;
}

} // namespace

QList<Outcome> Service::write(Line &line, int address, const Changes &changes) const
{
    QList<Outcome> outcomes;
    for (const Setting setting : {Setting::Name, Setting::Offset, Setting::Ticks, Setting::Period}) {
        if (!has(changes, setting)) {
            continue;
        }
        outcomes.append({setting, writeOne(line, address, changes, setting)});
        const Result<void> &written = outcomes.constLast().written;
        if (!written && isLineFault(written.fault())) {
            break;
        }
    }
    return outcomes;
}

/// What was written counts by what is read back: an answer may be lost, and so may the request; a late one may tell the
/// old value.
Result<void> Service::writeOne(Line &line, int address, const Changes &changes, Setting setting) const
{
    const auto sent = withAttempts([&] { return confirmed(exchange(line, setRequest(address, changes, setting))); });
    if (!sent && !isWorthAnother(sent.fault())) {
        return sent;
    }
    bool wasRead = false;
    Result<void> held = Fault::Timeout;
    for (int i = 0; i < mostAttempts && !held && isWorthAnother(held.fault()); ++i) {
        held = isHeld(line, address, changes, setting);
        wasRead = wasRead || (!held && held.fault() == Fault::BadReply);
    }
    return !held && held.fault() == Fault::Timeout && wasRead ? Result<void>(Fault::BadReply) : held;
}

/// Empty: out of range, or a setting that the protocol does not have.
std::optional<Request> Service::setRequest(int address, const Changes &changes, Setting setting) const
{
    const bool isModbus = m_dialect == Dialect::Modbus;
    if (m_dialect == Dialect::V210) {
        return std::nullopt;
    }
    switch (setting) {
    case Setting::Name: return isModbus ? std::nullopt : setName(address, *changes.name);
    case Setting::Offset:
        return isModbus ? modbus::setOffset(address, *changes.offset) : setOffset(address, *changes.offset);
    case Setting::Ticks:
        return isModbus ? modbus::setTicks(address, *changes.ticks) : setTicks(address, *changes.ticks);
    case Setting::Period:
        return isModbus ? modbus::setPeriod(address, *changes.period) : setPeriod(address, *changes.period);
    }
    return std::nullopt;
}

/// One question; BadReply: the sensor holds another value.
Result<void> Service::isHeld(Line &line, int address, const Changes &changes, Setting setting) const
{
    if (m_dialect == Dialect::Modbus) {
        return isHeldModbus(line, address, changes, setting);
    }
    const auto about = [address](Packet packet) { return ind3::ask(packet, address); };
    switch (setting) {
    case Setting::Name: return isSame(question(line, about(Packet::GetName), decodeNameAnswer), *changes.name);
    case Setting::Offset: return isSame(question(line, about(Packet::GetOffset), decodeOffset), *changes.offset);
    case Setting::Ticks: return isSame(question(line, about(Packet::GetTicks), decodeTicks), *changes.ticks);
    case Setting::Period: return isSame(question(line, about(Packet::GetPeriod), decodePeriod), *changes.period);
    }
    return Fault::Refused;
}

Result<void> Service::isHeldModbus(Line &line, int address, const Changes &changes, Setting setting) const
{
    if (setting == Setting::Offset) {
        return isSame(question(line, modbus::readOwnOffset(address), modbus::decodeOwnOffset), *changes.offset);
    }
    const auto read = question(line, modbus::readSettings(address), modbus::decodeSettings);
    if (!read) {
        return read.fault();
    }
    return setting == Setting::Ticks ? isSame<int>(read->ticks, *changes.ticks)
                                     : isSame<std::chrono::milliseconds>(read->period, *changes.period);
}

} // namespace gorizont::ind3
