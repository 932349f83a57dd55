#include "core/export/exportrequest.h"

namespace gorizont {

QList<SeriesKey> exportedSeries(const ExportRequest &request)
{
    QList<SeriesKey> keys;
    for (const SensorConfig &sensor : request.sensors) {
        const QList<Quantity> measured = quantitiesOf(sensor);
        for (const Quantity quantity : request.quantities) {
            if (measured.contains(quantity)) {
                keys << SeriesKey{sensor.number, quantity};
            }
        }
    }
    return keys;
}

QList<SensorConfig> exportedAccelerometers(const ExportRequest &request)
{
    QList<SensorConfig> sensors;
    for (const SensorConfig &sensor : request.sensors) {
        if (sensor.measuresAcceleration) {
            sensors << sensor;
        }
    }
    return sensors;
}

} // namespace gorizont
