#pragma once

#include "core/devices/lvims/lvimsregisters.h"

#include <QList>
#include <QString>

namespace gorizont::lvims {

/// Consecutive registers as they were read, and the values in them by the rows of the table; manual 003, section 2.1. What lies
/// outside reads as 0 or empty.
class Words
{
public:
    Words(quint16 first, QList<quint16> values)
        : m_first(first)
        , m_values(std::move(values))
    {
    }

    quint16 word(const Register &entry, int channel = 0, int item = 0) const;
    quint32 doubleWord(const Register &entry, int channel = 0, int item = 0) const; ///< low word first
    float real(const Register &entry, int channel = 0, int item = 0) const; ///< low word first
    QString text(const Register &entry) const; ///< low byte first, up to a zero
    QString ipAddress(const Register &entry) const; ///< low byte first, `192.168.1.10`

    /// The set of registers at \a entry, counted from its first one.
    Words set(const Register &entry, int channel = 0, int item = 0) const;

    const QList<quint16> &values() const { return m_values; }

private:
    quint16 at(int address) const { return m_values.value(address - m_first, 0); }

    quint16 m_first;
    QList<quint16> m_values;
};

/// The same values as registers to be written.
QList<quint16> fromDoubleWord(quint32 value);
QList<quint16> fromReal(float value);
/// As many as \a registers; what does not fit, or half a character of it, is cut off.
QList<quint16> fromText(const QString &text, int registers);

} // namespace gorizont::lvims
