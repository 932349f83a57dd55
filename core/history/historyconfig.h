#pragma once

#include "core/values/lineconfig.h"

#include <QTimeZone>

#include <chrono>

namespace gorizont {

/// What the history has to know of the ini.
struct HistoryConfig
{
    static constexpr int samplesPerPacket = 32;

    QString folder; ///< `…/History`; created when needed
    std::chrono::milliseconds saveInterval{1000}; ///< TmSave
    int ringPackets = 8192; ///< SrsBufSize
    int packetsToSave = 1; ///< SrsBufToSave: a pair holds ringPackets × 32 × packetsToSave samples
    bool savesFiles = true; ///< CanSave; false: lines are made and shown, never written
    QList<LineConfig> lines;
    QTimeZone zone = QTimeZone::systemTimeZone();
    std::chrono::milliseconds retryInterval{3000}; ///< after a failure the disk is asked this often

    qint64 samplesPerRing() const { return qint64{ringPackets} * samplesPerPacket; }
};

} // namespace gorizont
