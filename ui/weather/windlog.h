#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/windrose.h"

namespace gorizont {

/// Gathers the winds of all weather stations while the program runs, whether somebody looks or not. GUI thread.
class WindLog : public QObject
{
    Q_OBJECT

public:
    /// The registry outlives the log.
    explicit WindLog(const SensorRegistry &registry, QObject *parent = nullptr);

    /// Of station N \a number within \a span before \a now.
    WindCounts over(int number, std::chrono::minutes span, SteadyTime now) const;

private:
    void take(const Readings &batch);

    QHash<int, WindRecord> m_records; ///< N → its winds
};

} // namespace gorizont
