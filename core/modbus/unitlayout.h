#pragma once

#include "core/modbus/registerfield.h"
#include "core/modbus/unitstate.h"

#include <span>

namespace gorizont {

using HeadField = RegisterField<HeadState>;
using SlotField = RegisterField<SlotState>;

/// The fields are in ascending order, do not overlap and end before register \a end.
template <typename Fields> constexpr bool areApart(const Fields &fields, int end)
{
    int next = 0;
    for (const auto &field : fields) {
        if (field.offset < next) {
            return false;
        }
        next = field.offset + registerCount(field.type);
    }
    return next <= end;
}

/// The same registers for slot after slot.
struct SlotPart
{
    const char *name; ///< for machines; empty where there is only one part
    const char *meaning; ///< source text of context RegisterMap
    int start; ///< register of slot 0, counted from the start of the block
    int stride; ///< registers from one slot to the next
    std::span<const SlotField> fields;
};

/// Registers of those sensors that have more values than their part of a slot holds: an area for each of them in the order of
/// the slots, the first at the end of the address space and every other below the one before, so that they stay where they are
/// when slots are added.
struct AreaPart
{
    const char *meaning; ///< source text of context RegisterMap
    int first; ///< register of the first area, counted from the start of the block
    int step; ///< registers of an area
    int most; ///< areas; sensors beyond have none
    bool (*has)(const SensorConfig &sensor);
    std::span<const SlotField> fields;

    int start(int ordinal) const { return first - step * ordinal; }
};

/// What stands where in one unit: the table that its image and its document are made from.
struct UnitLayout
{
    int unit; ///< the address of the slave in a request
    const char *title; ///< source text of context RegisterMap
    const char *remark; ///< source text of context RegisterMap; empty: none
    RegisterOrder order;
    bool isHolding; ///< function 03 reads the same as 04
    bool followsBase; ///< ModbusBase moves the block
    SensorSlots::Member member; ///< which sensors have a slot; nullptr: all
    std::span<const HeadField> head; ///< from the start of the block
    std::span<const SlotPart> parts; ///< in ascending order of start; the last one is open
    const AreaPart *areas = nullptr; ///< nullptr: none

    /// Registers of a block with \a slotCount slots and \a areaCount areas; what lies between them is reserved.
    int size(int slotCount, int areaCount) const
    {
        return areaCount > 0 ? areas->first + areas->step : parts.back().start + parts.back().stride * slotCount;
    }
    /// The register where the block starts.
    int base(int configured) const { return followsBase ? configured : 0; }
    /// How many slots there is room for below register 65536, or below \a areaCount areas, when the block starts at \a base.
    int limit(int base, int areaCount) const;
    /// How many of the sensors of \a lines have an area.
    int areaCount(const QList<LineConfig> &lines) const;
};

} // namespace gorizont
