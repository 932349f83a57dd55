#pragma once

class QCPAxis;
class QCustomPlot;

namespace gorizont {

/// Colours and fonts of a plot, from the palette of its widget: light or dark as the rest of the window.
namespace plotlook {

void dress(QCustomPlot &plot);
void dress(QCPAxis &axis, const QCustomPlot &plot);

} // namespace plotlook

} // namespace gorizont
