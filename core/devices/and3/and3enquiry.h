#pragma once

#include "core/devices/and3/and3protocol.h"
#include "core/values/deviceinformation.h"
#include "core/values/timing.h"

#include <optional>

namespace gorizont::and3 {

/// What the sensor is asked of itself by 36 and what it has said so far. Each question comes once a minute, one at a time,
/// and the sensors of a line do not ask in the same second, so that no polling cycle grows by more than one of them.
/// Pure: time is given.
class Enquiry
{
public:
    static constexpr int questions = 6;
    static constexpr std::chrono::seconds round{60};
    static constexpr std::chrono::seconds pause = round / questions;

    explicit Enquiry(int number) { m_known.number = number; }

    /// The first time this is called the clock starts. A clock of the computer that was set makes a question due.
    bool isDue(UtcTime now);

    /// The next question; it counts as asked.
    InformationKind next(UtcTime now);

    /// The answer to \a kind. True: it says something new.
    bool take(InformationKind kind, QByteArrayView answer);

    const DeviceInformation &known() const { return m_known; }

private:
    int m_position = 0;
    std::optional<UtcTime> m_nextAt;
    DeviceInformation m_known;
};

} // namespace gorizont::and3
