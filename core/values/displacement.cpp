#include "core/values/displacement.h"

#include <cmath>
#include <numbers>

namespace gorizont {

Displacement linkDisplacement(const Tilt &tilt, double length)
{
    constexpr double radiansPerArcSecond = std::numbers::pi / (180.0 * 3600.0);
    constexpr double millimetres = 1000;
    return {
        millimetres * length * std::sin(tilt.x * radiansPerArcSecond),
        millimetres * length * std::sin(tilt.y * radiansPerArcSecond)};
}

std::vector<ChainNode> chainNodes(const ChainConfig &chain, const std::function<std::optional<Tilt>(int)> &tiltOf)
{
    std::vector<ChainNode> nodes;
    double height = 0;
    std::optional<Displacement> sum = Displacement{};
    for (const ChainLink &link : chain.links) {
        height += link.length;
        ChainNode node{link.number, height, {}, {}};
        if (const auto tilt = tiltOf(link.number)) {
            node.own = linkDisplacement(*tilt, link.length);
        }
        if (sum && node.own) {
            sum = Displacement{sum->x + node.own->x, sum->y + node.own->y};
        } else {
            sum.reset();
        }
        node.sum = sum;
        nodes.push_back(node);
    }
    return nodes;
}

} // namespace gorizont
