#include "core/devices/addressscan.h"

#include <algorithm>

namespace gorizont {

AddressScan::AddressScan(int from, int to)
    : m_from(std::clamp(from, first, last))
    , m_to(std::clamp(to, m_from, last))
{
}

int AddressScan::next() const
{
    return m_probed < count() ? m_from + m_probed : 0;
}

void AddressScan::record(const Result<void> &probed)
{
    const int address = next();
    if (address == 0 || (!probed && isLineFault(probed.fault()))) {
        return;
    }
    Finding finding = Finding::Sensor;
    if (!probed) {
        finding = probed.fault() == Fault::Timeout ? Finding::Nobody : Finding::Unclear;
    }
    m_findings[static_cast<std::size_t>(address)] = finding;
    ++m_probed;
}

QList<int> AddressScan::addresses(Finding finding) const
{
    QList<int> list;
    for (int address = first; address <= last; ++address) {
        if (m_findings[static_cast<std::size_t>(address)] == finding) {
            list.append(address);
        }
    }
    return list;
}

} // namespace gorizont
