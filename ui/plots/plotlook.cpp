#include "ui/plots/plotlook.h"

#include "ui/models/colours.h"
#include "ui/plots/plotting.h"

namespace gorizont::plotlook {

void dress(QCPAxis &axis, const QCustomPlot &plot)
{
    const QColor text = plot.palette().color(QPalette::Text);
    const QColor muted = colours::mutedText(plot.palette());
    QColor grid = muted;
    grid.setAlphaF(0.25F);
    axis.setBasePen(QPen(muted));
    axis.setTickPen(QPen(muted));
    axis.setSubTickPen(QPen(muted));
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    axis.setTickLabelFont(plot.font());
    axis.setLabelFont(plot.font());
    axis.setLabelPadding(2);
    axis.grid()->setPen(QPen(grid, 0));
    axis.grid()->setSubGridVisible(false);
    axis.grid()->setZeroLinePen(QPen(grid, 0));
}

void dress(QCustomPlot &plot)
{
    const QColor text = plot.palette().color(QPalette::Text);
    plot.setBackground(QBrush(plot.palette().color(QPalette::Base)));
    for (QCPAxisRect *rect : plot.axisRects()) {
        for (QCPAxis *axis : rect->axes()) {
            dress(*axis, plot);
        }
    }
    if (plot.legend) {
        plot.legend->setBrush(Qt::NoBrush);
        plot.legend->setBorderPen(Qt::NoPen);
        plot.legend->setFont(plot.font());
        plot.legend->setTextColor(text);
        plot.legend->setIconSize(34, plot.fontMetrics().height());
    }
}

} // namespace gorizont::plotlook
