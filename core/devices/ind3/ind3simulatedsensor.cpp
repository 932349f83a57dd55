#include "core/devices/ind3/ind3simulatedsensor.h"

#include <algorithm>
#include <cmath>

namespace gorizont::ind3 {

namespace {

QByteArray threeBytes(double angle)
{
    int high = angle < 0 ? 0x80 : 0;
    double magnitude = std::fabs(angle);
    if (magnitude >= 16383.5) {
        magnitude = std::min(magnitude / 60, 16383.0); // there is nothing beyond
        high |= 0x40;
    }
    int whole = static_cast<int>(std::floor(magnitude));
    int fraction = static_cast<int>(std::floor((magnitude - whole) * 256 + 0.5));
    if (fraction == 256) {
        fraction = 0;
        ++whole;
    }
    high |= whole / 256;
    return {QByteArray(1, char(fraction)) + char(whole % 256) + char(high)};
}

} // namespace

QByteArray angleBytes(double y, double x)
{
    return threeBytes(y) + threeBytes(x);
}

double angleOfBytes(const QByteArray &bytes)
{
    const int fraction = static_cast<unsigned char>(bytes.at(0));
    const int low = static_cast<unsigned char>(bytes.at(1));
    const int high = static_cast<unsigned char>(bytes.at(2));
    double angle = high % 64 * 256 + low + fraction / 256.0;
    if (high & 0x40) {
        angle *= 60;
    }
    return high & 0x80 ? -angle : angle;
}

} // namespace gorizont::ind3
