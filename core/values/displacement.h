#pragma once

#include "core/values/reading.h"

#include <QString>

#include <functional>
#include <vector>

namespace gorizont {

/// A rigid piece of a building whose tilt one sensor measures.
struct ChainLink
{
    int number = 0; ///< N{i}, the sensor
    double length = 0; ///< L{i}, m, > 0
    bool operator==(const ChainLink &) const = default;
};

/// [Chain{k}]: links that stand on each other. Their tilts make the shape of a column (manual 002, section 2.3;
/// spec/usm-isn.md, 13).
struct ChainConfig
{
    int index = 0; ///< {k}
    QString name;
    QList<ChainLink> links; ///< from the bottom
    bool operator==(const ChainConfig &) const = default;
};

/// The upper end of a link. What a sensor does not say now is empty, and so is every sum above it.
struct ChainNode
{
    int number = 0; ///< N, the sensor
    double height = 0; ///< m above the foot of the chain, along it
    std::optional<Displacement> own; ///< over the lower end of the link: M = L·sin α
    std::optional<Displacement> sum; ///< over the foot of the chain
    bool operator==(const ChainNode &) const = default;
};

/// \a length in m.
Displacement linkDisplacement(const Tilt &tilt, double length);

/// The nodes of \a chain from the bottom. \a tiltOf gives the tilt of a sensor that is valid now.
std::vector<ChainNode> chainNodes(
    const ChainConfig &chain, const std::function<std::optional<Tilt>(int number)> &tiltOf);

} // namespace gorizont
