#include "core/simulation/faultplan.h"

#include <QRegularExpression>

#include <array>
#include <cmath>

namespace gorizont {

namespace {

using Kind = SimulatedFault::Kind;

struct KindName
{
    QLatin1StringView name;
    Kind kind;
    bool isPercent;
};

constexpr std::array<KindName, 8> kinds{{
    {QLatin1StringView("silent"), Kind::Silent, false},
    {QLatin1StringView("crc"), Kind::Crc, true},
    {QLatin1StringView("garbage"), Kind::Garbage, true},
    {QLatin1StringView("pieces"), Kind::Pieces, true},
    {QLatin1StringView("late"), Kind::Late, true},
    {QLatin1StringView("reboot"), Kind::Reboot, false},
    {QLatin1StringView("overrun"), Kind::Overrun, false},
    {QLatin1StringView("gone"), Kind::Gone, false},
}};

SimulatedFault::Time seconds(const QString &text)
{
    return SimulatedFault::Time(std::llround(text.toDouble() * 1e6));
}

} // namespace

std::optional<SimulatedFault> parseSimulatedFault(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral("^([a-z]+)=([0-9.]+)(?::([0-9.]+))?(?:@([0-9.]+)(?:-([0-9.]+))?)?$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    for (const KindName &known : kinds) {
        if (match.captured(1) != known.name) {
            continue;
        }
        SimulatedFault fault;
        fault.kind = known.kind;
        fault.value = match.captured(2).toDouble();
        fault.length = seconds(match.captured(3));
        fault.from = seconds(match.captured(4));
        if (match.hasCaptured(5)) {
            fault.to = seconds(match.captured(5));
        }
        const bool hasLength = match.hasCaptured(3);
        const bool isGood = hasLength == (fault.kind == Kind::Gone) && (!known.isPercent || fault.value <= 100);
        return isGood ? std::optional(fault) : std::nullopt;
    }
    return std::nullopt;
}

} // namespace gorizont
