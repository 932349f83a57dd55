#include "ui/plots/curvestyle.h"

#include <array>

namespace gorizont {

namespace {

constexpr int colours = 7;

/// Seven hues that the colour-blind tell apart (Okabe and Ito), darkened for white and lightened for black.
constexpr std::array<QRgb, colours> onLight{0xff0072b2, 0xffc04a00, 0xff00795a, 0xffa8377c,
                                            0xff8a6a00, 0xff1f7fb8, 0xff444444};
constexpr std::array<QRgb, colours> onDark{0xff4aa8e0, 0xfff08040, 0xff30c090, 0xffe080b8,
                                           0xffe8c840, 0xff80d0ff, 0xffd8d8d8};
constexpr std::array lines{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

} // namespace

CurveStyle curveStyle(int index, bool isDark)
{
    const auto colour = static_cast<std::size_t>(index % colours);
    const auto line = static_cast<std::size_t>(index) % lines.size();
    return {QColor::fromRgb(isDark ? onDark.at(colour) : onLight.at(colour)), lines.at(line)};
}

} // namespace gorizont
