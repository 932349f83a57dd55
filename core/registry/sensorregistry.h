#pragma once

#include "core/values/deviceinformation.h"
#include "core/values/displacement.h"
#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/quantity.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"
#include "core/values/statusword.h"
#include "core/values/vibrationcapture.h"

#include <QHash>
#include <QObject>

#include <vector>

namespace gorizont {

/// The last value of everything: the only hub between acquisition and its consumers. Main thread.
/// Lines stand in the order of the ini, sensors in ascending N; neither changes while the program runs.
class SensorRegistry : public QObject
{
    Q_OBJECT

public:
    struct Line
    {
        LineConfig config;
        LineStatus status;
        std::vector<int> sensors; ///< indices into sensors(), in the order of the ini
    };

    struct Sensor
    {
        SensorConfig config;
        int line = 0; ///< index into lines()
        Reading reading;
        quint64 packetsSaved = 0; ///< packets of samples that are in the binary files
        DeviceInformation information; ///< with CanInfo=1
    };

    SensorRegistry(const QList<LineConfig> &lines, const StatusRules &rules, QObject *parent = nullptr);

    const std::vector<Line> &lines() const { return m_lines; }
    const std::vector<Sensor> &sensors() const { return m_sensors; }

    /// Index into sensors() of site number \a number; −1: there is none.
    int indexOf(int number) const { return m_indexOfNumber.value(number, -1); }
    /// Index into lines() of section [Port\a port]; −1: there is none.
    int lineIndexOf(int port) const { return m_indexOfPort.value(port, -1); }

    /// Before the first reading; a sensor stands in one chain at most. From then on the readings of its sensors say what
    /// their tilt means there.
    void setChains(const QList<ChainConfig> &chains);
    const QList<ChainConfig> &chains() const { return m_chains; }
    /// The nodes of \a chain by the last readings.
    std::vector<ChainNode> nodesOf(const ChainConfig &chain) const;

    /// All readings as they are now, in ascending N: what a consumer starts from.
    Readings readings() const;
    QList<LineStatus> lineStatuses() const;

public Q_SLOTS:
    /// Takes over a batch; readings of unknown sensors are ignored.
    void update(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);
    void addBlock(const gorizont::SampleBlock &block);
    void addCapture(const gorizont::SignalCapture &captured);
    void setPacketsSaved(int number, quint64 packets);
    /// Told to nobody: it changes once a minute, and whoever shows it looks here.
    void setInformation(const gorizont::DeviceInformation &information);

Q_SIGNALS:
    void readingsChanged(const QList<gorizont::Reading> &batch);
    void lineChanged(const gorizont::LineStatus &status);
    void blockAdded(const gorizont::SampleBlock &block);
    void captureAdded(const gorizont::SignalCapture &captured);

private:
    std::optional<Tilt> tiltOf(int number) const;
    std::optional<LinkDisplacement> displacementOf(int number) const;

    std::vector<Line> m_lines;
    std::vector<Sensor> m_sensors;
    QHash<int, int> m_indexOfNumber;
    QHash<int, int> m_indexOfPort;
    QList<ChainConfig> m_chains;
    QHash<int, qsizetype> m_chainOfNumber; ///< N → index into m_chains
};

} // namespace gorizont
