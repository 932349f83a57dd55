#include "core/devices/and3/and3enquiry.h"

#include "core/devices/and3/and3answers.h"

#include <array>
#include <utility>

namespace gorizont::and3 {

namespace {

using namespace std::chrono_literals;

/// In the order of the questions.
constexpr std::array<InformationKind, Enquiry::questions> kinds{
    InformationKind::Firmware, InformationKind::SystemClock,     InformationKind::HeaterPower,
    InformationKind::FanPower, InformationKind::InnerTransducer, InformationKind::ResponseTime,
};

std::optional<quint32> &place(DeviceInformation &information, InformationKind kind)
{
    switch (kind) {
    case InformationKind::HeaterPower: return information.heaterPower;
    case InformationKind::FanPower: return information.fanPower;
    case InformationKind::InnerTransducer: return information.innerTransducer;
    case InformationKind::ResponseTime: return information.responseTime;
    case InformationKind::SystemClock:
    case InformationKind::Firmware: break;
    }
    return information.systemClock;
}

QString firmwareText(const Firmware &firmware)
{
    return QStringLiteral("%1.%2.%3").arg(firmware.version).arg(firmware.subVersion).arg(firmware.build);
}

} // namespace

bool Enquiry::isDue(UtcTime now)
{
    if (!m_nextAt) {
        m_nextAt = now + m_known.number % (pause / 1s) * 1s;
    }
    return now >= *m_nextAt || *m_nextAt - now > pause;
}

InformationKind Enquiry::next(UtcTime now)
{
    m_nextAt = now + pause;
    const auto position = static_cast<std::size_t>(std::exchange(m_position, (m_position + 1) % questions));
    return kinds[position];
}

bool Enquiry::take(InformationKind kind, QByteArrayView answer)
{
    const DeviceInformation before = m_known;
    if (kind == InformationKind::Firmware) {
        if (const auto firmware = parseFirmware(answer)) {
            m_known.firmware = firmwareText(*firmware);
        }
    } else if (const auto value = parseInformation(answer)) {
        place(m_known, kind) = value;
    }
    return m_known != before;
}

} // namespace gorizont::and3
