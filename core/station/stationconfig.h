#pragma once

#include "core/station/boardfile.h"
#include "core/station/gammafile.h"
#include "core/station/objectsfile.h"
#include "core/station/parameterfile.h"
#include "core/station/settingsfile.h"

#include <QMap>

namespace gorizont::station {

/// The files of a station by the name that the station gives them (canonicalName()), and what is in them.
using StationFiles = QMap<QString, QByteArray>;

/// `АСК.par` → `ACK.PAR`, `input.р01` → `INPUT.P01`: in capitals, and Latin where a Cyrillic letter looks alike. Empty: a station
/// has no file of such a name.
QString canonicalName(const QString &name);

/// All files of a station, resolved against each other.
struct StationConfig
{
    StationSettings settings; ///< ACK.PSE
    QList<StationObject> objects; ///< ACK.INI
    QList<ParameterConfig> parameters; ///< ACK.PAR; every index of a parameter means this list
    QList<Corrections> corrections; ///< one for each parameter
    QList<BoardConfig> boards; ///< ACK.LCD, then ACK.FWL: those that there are
    std::optional<GammaConfig> gamma; ///< ACK.GAM

    /// The index of a parameter; its letter in the same case, else in any. -1: there is none.
    int indexOf(const ParameterId &id) const;
    /// The first parameter with code t or T; -1: there is none.
    int thermometer() const;
    /// Every parameter once: those that the boards name in their order, then the others as in ACK.PAR. The supply voltage (U) goes
    /// first whatever the boards say, for all others depend on it.
    QList<int> processingOrder() const;
    std::chrono::seconds averaging(int parameter) const; ///< 1 s…
    int instantSeconds(int parameter) const; ///< of the board that measures it, else of the first board, else 1
    bool isTest() const; ///< by ACK.PSE or a board
    /// The bit of DIG of a digital input: those of a second board follow the string of the first.
    int bitOf(qsizetype board, const BoardInput &input) const;
    /// The bit of the first sensor of precipitation; empty: there is none.
    std::optional<int> precipitationBit() const;

    bool operator==(const StationConfig &) const = default;
};

struct StationReading
{
    StationConfig config;
    QList<StationComplaint> complaints;
};

/// Pure: every mistake becomes a complaint, the result is always usable.
StationReading readStation(const StationFiles &files);

} // namespace gorizont::station
