#pragma once

#include "core/opc/opcsample.h"
#include "core/opc/opctags.h"

#include <QHash>

#include <vector>

namespace gorizont {

/// The present worth of every tag, kept up to date by readings and states of lines. One thread.
class OpcImage
{
public:
    OpcImage(const QList<LineConfig> &lines, const QList<OpcTag> &tags, UtcTime start);

    const QList<OpcTag> &tags() const { return m_tags; }
    const OpcSample &sample(int index) const { return m_samples[static_cast<std::size_t>(index)]; }

    /// Indices of the tags that changed are added to \a changed. A reading of an unknown sensor changes nothing.
    void update(const Reading &reading, std::vector<int> &changed);
    void update(const LineStatus &status, UtcTime now, std::vector<int> &changed);

private:
    struct Sensor
    {
        SensorConfig config;
        std::vector<int> tags; ///< indices
        Reading reading; ///< the last one
    };

    void refresh(Sensor &sensor, UtcTime time, std::vector<int> &changed);

    const QList<OpcTag> m_tags;
    std::vector<OpcSample> m_samples; ///< as the tags
    QHash<int, Sensor> m_sensors; ///< N →
    QHash<int, LineStatus> m_lines; ///< port →
};

} // namespace gorizont
