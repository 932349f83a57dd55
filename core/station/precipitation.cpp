#include "core/station/precipitation.h"

namespace gorizont::station {

void PrecipitationWatch::update(bool isWet, qint64 clock)
{
    if (isWet == m_isWet) {
        return;
    }
    m_isWet = isWet;
    m_events.prepend({isWet, clock});
    if (m_events.size() > mostEvents) {
        m_events.removeLast();
    }
}

} // namespace gorizont::station
