#pragma once

#include <QColor>
#include <Qt>

namespace gorizont {

/// How a curve is told from the others: no two of the first 28 have both the same colour and the same line.
struct CurveStyle
{
    QColor colour;
    Qt::PenStyle line = Qt::SolidLine;
    bool operator==(const CurveStyle &) const = default;
};

/// Of the curve \a index, counted from 0, on a light or dark background. Neighbours differ in both. Pure.
CurveStyle curveStyle(int index, bool isDark);

} // namespace gorizont
