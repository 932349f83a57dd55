#pragma once

#include "core/modbus/registerblock.h"
#include "core/modbus/unitlayout.h"

#include <vector>

namespace gorizont {

/// The registers of one unit, always ready to be sent, as its layout says. One thread.
///
/// A value of several registers is never torn: a reading is written and a request is answered each as a whole by the
/// same thread. What a client reads with one request is therefore of one moment; with two requests it need not be.
class UnitImage
{
public:
    /// \a configuredBase is ModbusBase. The layout lives as long as the program.
    UnitImage(const UnitLayout &layout, int configuredBase, const SensorSlots &slotMap, int areaCount);

    const UnitLayout &layout() const { return *m_layout; }
    const SensorSlots &slotMap() const { return m_slots; }
    const RegisterBlock &block() const { return m_block; }
    /// Register where the area of \a slot starts; 0: it has none.
    int areaAt(int slot) const { return m_states.at(static_cast<std::size_t>(slot)).areaAt; }

    void setChannels(quint32 word);
    /// O(1), in place; the reading of a sensor that is not in the unit is ignored.
    void update(const Reading &reading);

    /// \a registers is a copy of registers \a address … \a address + \a count − 1: brings the clocks among them up to
    /// \a now, also those that are only partly there.
    void writeClocks(char *registers, int address, int count, const Moment &now) const;
    bool hasClocks() const { return m_hasClocks; }

private:
    Moment clocks() const;
    template <typename State>
    void writeFields(std::span<const RegisterField<State>> fields, int start, const State &state, const Moment &now);
    void writeHead(const Moment &now);
    void writeSlot(int slot, const Moment &now);

    const UnitLayout *m_layout;
    SensorSlots m_slots;
    RegisterBlock m_block;
    HeadState m_head;
    std::vector<SlotState> m_states;
    bool m_hasClocks;
};

} // namespace gorizont
