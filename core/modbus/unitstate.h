#pragma once

#include "core/modbus/sensorslots.h"
#include "core/values/reading.h"

#include <array>

namespace gorizont {

/// What the registers of one slot are made from.
struct SlotState
{
    SensorSlot slot;
    Reading reading; ///< the last one
    std::optional<UtcTime> answeredAt; ///< of the last answer; empty: none so far
    /// The values of the last answer still stand: it was the last turn, or too few have failed since to change the status.
    bool isCurrent = false;
    int areaAt = 0; ///< register where its area starts; 0: it has none

    explicit SlotState(const SensorSlot &own)
        : slot(own)
    {
        reading.number = own.sensor.number;
        reading.status = own.initialWord;
    }

    void take(const Reading &next)
    {
        isCurrent = next.isAnswer || (isCurrent && next.status == reading.status);
        reading = next;
        if (next.isAnswer) {
            answeredAt = next.time;
        }
    }
};

/// What the registers at the head of a unit are made from.
struct HeadState
{
    int slotCount = 0; ///< holes included
    int sensors = 0;
    int switchedOff = 0;
    int current = 0;
    std::array<int, 16> withCode{}; ///< how many sensors have that code in bits 15…12 of their status word
    quint32 channels = 0; ///< the channel word
    SteadyTime started = SteadyTime::clock::now();

    /// Counts a sensor in (\a by = 1) or out (−1).
    void count(const SlotState &state, int by)
    {
        if (!state.slot.isHole()) {
            sensors += by;
            switchedOff += state.reading.status & statusbit::NotPolled ? by : 0;
            current += state.isCurrent ? by : 0;
            withCode[state.reading.status >> 12] += by;
        }
    }
};

} // namespace gorizont
