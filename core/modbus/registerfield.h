#pragma once

#include "core/values/timing.h"

#include <QByteArrayView>

#include <array>
#include <optional>

namespace gorizont {

/// What one register holds, or several in a row.
enum class RegisterType : quint8 { Int16, UInt16, UInt32, UInt64, Float32 };

/// How the bytes of a value follow each other on the wire.
enum class RegisterOrder : quint8 {
    LowByteFirst, ///< manual 000, 10.3: a little-endian byte stream, so every register is byte-swapped
    HighByteFirst, ///< as Modbus is usually read: the high byte first, of several registers the high one first
};

constexpr int registerCount(RegisterType type)
{
    switch (type) {
    case RegisterType::Int16:
    case RegisterType::UInt16: return 1;
    case RegisterType::UInt32:
    case RegisterType::Float32: return 2;
    case RegisterType::UInt64: return 4;
    }
    return 1;
}

/// A value as it goes over the wire: two bytes a register.
class RegisterBytes
{
public:
    /// \a value in units of 1/\a scale. Integers are rounded and saturated by registerValue(). A float that has no value
    /// is the quiet NaN 7FC00000h; so is what a float cannot hold.
    RegisterBytes(double value, double scale, RegisterType type, RegisterOrder order);

    QByteArrayView view() const { return QByteArrayView(m_bytes.data(), m_size); }

private:
    std::array<char, 8> m_bytes{};
    qsizetype m_size = 0;
};

/// One instant by both clocks.
struct Moment
{
    UtcTime utc;
    SteadyTime steady;

    static Moment now() { return {utcNow(), SteadyTime::clock::now()}; }
};

/// One row of the table that both the image of a unit and its document are made from. State is what values are taken
/// from. Exactly one of \a value and \a clock is there.
template <typename State> struct RegisterField
{
    int offset; ///< registers from the start of the part it belongs to
    RegisterType type;
    double scale; ///< what stands in the register for one unit
    const char *name; ///< for machines, the same in every language
    const char *unit; ///< source text of context RegisterMap; empty: a plain number
    const char *meaning; ///< source text of context RegisterMap
    /// In \a unit; empty: the registers stay as they are.
    std::optional<double> (*value)(const State &state);
    /// For what changes by itself: written into each answer as it leaves.
    double (*clock)(const State &state, const Moment &now) = nullptr;
};

} // namespace gorizont
