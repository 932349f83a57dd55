#pragma once

#include <QList>

#include <optional>

namespace gorizont::usmisn {

/// The non-volatile memory of a simulated УСМ-ИСН, and its counter. It shares no line of code with the codec.
class SimulatedMemory
{
public:
    static constexpr int capacity = 1720; ///< records of both channels

    struct Record
    {
        qint64 timestamp = 0; ///< seconds since 1970
        int channel = 0;
        quint32 count = 0; ///< of all measurements that were ever stored, this one included
        double value = 0; ///< degrees
        double variation = 0; ///< degrees
        double temperature = 0; ///< °C
        bool isOutOfRange = false;
        bool isRead = false;
    };

    /// Gives \a record the next count; the oldest record makes room.
    const Record &store(Record record);
    /// The last \a count records of \a channel (0: all), the oldest first; \a isOnlyNew: of those that were not read. They
    /// count as read from now on.
    QList<Record> read(int count, bool isOnlyNew, int channel);

    qsizetype size() const { return m_records.size(); }

private:
    QList<Record> m_records;
    quint32 m_count = 0;
};

} // namespace gorizont::usmisn
