#pragma once

#include <QString>

#include <optional>

namespace gorizont {

/// The families of devices, each with a wire protocol of its own.
enum class SensorType : quint8 {
    None, ///< the name holds no keyword: known to the program, never polled
    InD, ///< ИН-Д2, ИН-Д3, ИН-Д7, ИН-Д9
    AnD3, ///< АН-Д3
    UsmIsn, ///< УСМ-ИСН
    LVims, ///< L-VIMS
    Mk14, ///< МК-14
};

/// What the keywords of `Name{i}` say about a sensor (spec/gorizont.md, section 1).
struct NameKeywords
{
    SensorType type = SensorType::None;
    QString model; ///< Latin spelling for machines: `IN-D3`, `AN-D3`, …; empty without a type
    bool hasThermometer = false; ///< TMP05
    bool hasAcceleration = false; ///< ускорение
    bool hasThermostat = false; ///< подогрев
    bool operator==(const NameKeywords &) const = default;
};

/// Finds the keywords anywhere in \a name. Letters that look alike in Cyrillic and Latin, the digit 3 and the letter З,
/// and all kinds of dashes are the same. Of several types the one in parentheses wins, else the first.
NameKeywords readKeywords(const QString &name);

/// How operators read a model: `IN-D3` → `ИН-Д3`. An unknown model is returned as it is.
QString modelInRussian(const QString &model);

} // namespace gorizont
