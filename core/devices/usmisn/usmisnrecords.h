#pragma once

#include "core/devices/usmisn/usmisnvalues.h"
#include "core/values/devicerecord.h"
#include "core/values/sensorconfig.h"

#include <QList>

#include <map>

namespace gorizont::usmisn {

/// The records of recorders, each once, however often a transfer was broken off and begun again. Pure.
class RecordBook
{
public:
    /// False: this measurement of this channel is known already, or it is not a stored one.
    bool add(const Value &record);

    qsizetype size() const { return static_cast<qsizetype>(m_records.size()); }
    QList<Value> records() const; ///< by device, by number of measurement, X before Y
    void clear() { m_records.clear(); }

    /// How many numbers are missing between the first and the last measurement known of each device. The counter is that
    /// of the device, so a number that either channel has is not missing.
    qint64 missing() const;

private:
    struct Key
    {
        quint32 serial;
        quint32 measurement;
        int channel;
        auto operator<=>(const Key &) const = default;
    };

    std::map<Key, Value> m_records;
};

/// As the archive keeps \a record of the sensor N \a number: under channel and number of measurement, so that it is there once.
DeviceRecord deviceRecord(const Value &record, int number);

/// What \a records (ordered like RecordBook::records()) say of \a sensor, corrected like every reading: X and Y of one
/// measurement of a recorder together. One that lacks its other axis says nothing.
Readings readingsOf(const QList<Value> &records, const SensorConfig &sensor);

/// The records as a table for other programs: RFC 4180 with commas, a point in numbers, UTC in ISO 8601, one record a line.
namespace csv {
QByteArray header(); ///< with its end of line, as all of these
/// A value out of range is an empty field.
QByteArray line(const Value &record);
/// Empty: not such a line.
std::optional<Value> parse(const QByteArray &line);
} // namespace csv

} // namespace gorizont::usmisn
