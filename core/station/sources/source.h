#pragma once

#include "core/station/sources/rawsample.h"

#include <QString>

namespace gorizont::station {

/// A moment at which a source is asked.
struct SampleMoment
{
    std::chrono::duration<double> time{0}; ///< since the source was opened
    quint64 step = 0; ///< 0, 1, … in steps of 1/rate
    quint32 outputs = 0; ///< control word of the station's outputs
};

/// Where raw values come from. Used by one thread at a time, which it may block; whoever started that thread watches it.
class Source
{
public:
    virtual ~Source() = default;

    virtual QString name() const = 0; ///< for the journal
    virtual double rate() const = 0; ///< Hz: how often it wants to be asked, > 0

    /// Empty: it is ready. Else why not, in one sentence.
    virtual QString open() = 0;
    /// Adds what it measures to \a sample. Empty: good. Else why it has died.
    virtual QString measure(const SampleMoment &moment, RawSample &sample) = 0;
};

} // namespace gorizont::station
