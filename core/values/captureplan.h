#pragma once

#include "core/values/sensorconfig.h"
#include "core/values/vibrationcapture.h"

#include <QStringList>

#include <chrono>

namespace gorizont {

/// Continuous capture of a vibration module, as the ini asks for it: the driver reads when and what, the history how it is kept.
struct CapturePlan
{
    std::chrono::seconds every{0}; ///< `CaptureEvery{i}`, 1…86400; 0: off
    QList<int> channels{0, 1, 2, 3}; ///< `CaptureChannels{i}=0,1`; those that the module has switched off are left out
    QList<CaptureKind> kinds{CaptureKind::Waveform}; ///< `CaptureKinds{i}=waveform,5000,200`
    bool savesCsv = true; ///< `CaptureFormat{i}=csv,wav`; a spectrum is always CSV
    bool savesWav = false;
    std::chrono::days keep{0}; ///< `CaptureKeep{i}`, 1…36500; 0: for ever
    QStringList complaints; ///< what was not understood, a sentence each

    bool isOn() const { return every.count() > 0 && !channels.isEmpty() && !kinds.isEmpty(); }

    static CapturePlan from(const SensorConfig &sensor);
};

} // namespace gorizont
