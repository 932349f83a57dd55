#include "core/devices/usmisn/usmisnsimulatedmemory.h"

namespace gorizont::usmisn {

const SimulatedMemory::Record &SimulatedMemory::store(Record record)
{
    if (m_records.size() == capacity) {
        m_records.removeFirst();
    }
    record.count = ++m_count;
    m_records.append(record);
    return m_records.constLast();
}

QList<SimulatedMemory::Record> SimulatedMemory::read(int count, bool isOnlyNew, int channel)
{
    QList<Record> found;
    for (qsizetype i = m_records.size() - 1; i >= 0 && (count == 0 || found.size() < count); --i) {
        Record &record = m_records[i];
        if (record.channel == channel && !(isOnlyNew && record.isRead)) {
            record.isRead = true;
            found.prepend(record);
        }
    }
    return found;
}

} // namespace gorizont::usmisn
