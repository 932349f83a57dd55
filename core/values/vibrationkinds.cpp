#include "core/values/vibrationkinds.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

struct KindText
{
    Q_DECLARE_TR_FUNCTIONS(LVims)
};

constexpr int acceleration = 1;
constexpr qsizetype longestUnit = 16;

} // namespace

/// 13 to 15: the manual prints 13 and 15 alike and leaves 14 out (spec/l-vims.md, 6).
const std::array<MeasurementKind, 17> &measurementKinds()
{
    static constexpr const char *mmPerSecond2 = QT_TRANSLATE_NOOP("LVims", "mm/s²");
    static constexpr const char *mmPerSecond = QT_TRANSLATE_NOOP("LVims", "mm/s");
    static constexpr const char *micrometres = QT_TRANSLATE_NOOP("LVims", "µm");
    static constexpr const char *revolutions = QT_TRANSLATE_NOOP("LVims", "rpm");
    static constexpr std::array<MeasurementKind, 17> kinds{{
        {0, QT_TRANSLATE_NOOP("LVims", "not used"), ""},
        {1, QT_TRANSLATE_NOOP("LVims", "acceleration"), mmPerSecond2},
        {2, QT_TRANSLATE_NOOP("LVims", "velocity"), mmPerSecond},
        {3, QT_TRANSLATE_NOOP("LVims", "displacement"), micrometres},
        {4, QT_TRANSLATE_NOOP("LVims", "gap"), micrometres},
        {5, QT_TRANSLATE_NOOP("LVims", "speed of rotation"), revolutions},
        {6, QT_TRANSLATE_NOOP("LVims", "amplitude of a harmonic of acceleration"), mmPerSecond2},
        {7, QT_TRANSLATE_NOOP("LVims", "phase of a harmonic of acceleration"), "°"},
        {8, QT_TRANSLATE_NOOP("LVims", "amplitude of a harmonic of velocity"), mmPerSecond},
        {9, QT_TRANSLATE_NOOP("LVims", "phase of a harmonic of velocity"), "°"},
        {10, QT_TRANSLATE_NOOP("LVims", "amplitude of a harmonic of displacement"), micrometres},
        {11, QT_TRANSLATE_NOOP("LVims", "phase of a harmonic of displacement"), "°"},
        {12, QT_TRANSLATE_NOOP("LVims", "constant part of acceleration"), mmPerSecond2},
        {13, QT_TRANSLATE_NOOP("LVims", "RMS of a harmonic of acceleration"), mmPerSecond2},
        {14, QT_TRANSLATE_NOOP("LVims", "RMS of a harmonic of velocity"), mmPerSecond},
        {15, QT_TRANSLATE_NOOP("LVims", "RMS of a harmonic of displacement"), micrometres},
        {16, QT_TRANSLATE_NOOP("LVims", "largest deviation of the shaft from its mean"), micrometres},
    }};
    return kinds;
}

const MeasurementKind *measurementKind(int type)
{
    const bool isKnown = type >= 0 && type < static_cast<int>(measurementKinds().size());
    return isKnown ? &measurementKinds()[static_cast<std::size_t>(type)] : nullptr;
}

QString measurementName(int type)
{
    const MeasurementKind *kind = measurementKind(type);
    return kind != nullptr ? KindText::tr(kind->name) : QString();
}

MeasurementUnits::MeasurementUnits(const SensorConfig &sensor)
{
    const QString text = sensor.options.value(QStringLiteral("measunit"));
    for (const QString &entry : text.split(u',', Qt::SkipEmptyParts)) {
        take(entry.trimmed(), sensor);
    }
}

void MeasurementUnits::take(const QString &entry, const SensorConfig &sensor)
{
    const qsizetype colon = entry.indexOf(u':');
    const QString unit = entry.mid(colon + 1).trimmed();
    bool isNumber = colon < 0;
    const int type = colon < 0 ? acceleration : entry.left(colon).trimmed().toInt(&isNumber);
    const MeasurementKind *kind = isNumber && type > 0 ? measurementKind(type) : nullptr;
    if (kind == nullptr || unit.isEmpty() || unit.size() > longestUnit) {
        m_complaints.append(
            KindText::tr("MeasUnit%1: \"%2\" is not understood. It takes a unit for the accelerations, or TYPE:UNIT "
                         "with a type 1…16; the usual unit stays.")
                .arg(sensor.index)
                .arg(entry));
        return;
    }
    for (const MeasurementKind &other : measurementKinds()) {
        const bool isMeant = colon < 0 ? qstrcmp(other.unit, kind->unit) == 0 : other.type == type;
        if (isMeant) {
            m_own[static_cast<std::size_t>(other.type)] = unit;
        }
    }
}

QString MeasurementUnits::of(int type) const
{
    const MeasurementKind *kind = measurementKind(type);
    if (kind == nullptr) {
        return {};
    }
    const QString &own = m_own[static_cast<std::size_t>(type)];
    return own.isEmpty() && *kind->unit != '\0' ? KindText::tr(kind->unit) : own;
}

} // namespace gorizont
