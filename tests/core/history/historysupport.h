#pragma once

#include "core/values/lineconfig.h"
#include "core/values/sampleblock.h"

#include <QByteArray>
#include <QTimeZone>

namespace gorizont::test {

/// From here on this process cannot make a file longer than \a bytes: a write over the limit is short, as on a full
/// disk. Ends with the object.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(qint64 bytes);
    ~FileSizeLimit();
    Q_DISABLE_COPY_MOVE(FileSizeLimit)
};

QByteArray readAll(const QString &path);
void writeAll(const QString &path, const QByteArray &bytes);
QByteArray expectedFile(const char *name); ///< of tests/data/history

/// `2018-02-07T18:33:03` in a zone three hours east of Greenwich.
UtcTime moscow(const char *text);
QTimeZone moscowZone();

/// \a count samples that rise by one from \a first in X and fall from −\a first in Y.
SampleBlock samples(int number, UtcTime start, qint16 first, int count, bool followsPrevious = true);

SensorConfig tiltSensor(int number, bool hasThermometer = false);
SensorConfig accelerometer(int number);
SensorConfig vibrationModule(int number);

} // namespace gorizont::test
