// How the wind rose looks; what it shows stands in windroseview.cpp.

#include "ui/models/colours.h"
#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"
#include "ui/weather/windroseview.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

constexpr int margin = 6; ///< pixels
constexpr double innerShare = 0.13; ///< of the rim's radius

QPointF onCircle(QPointF centre, double radius, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    return centre + radius * QPointF(std::sin(angle), -std::cos(angle));
}

/// Between two radii, \a width degrees wide around \a degrees of the compass.
QPainterPath ringPart(QPointF centre, double from, double to, double degrees, double width)
{
    const auto square = [centre](double radius) {
        return QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    };
    const double start = 90 - degrees - width / 2; // Qt counts from the east against the clock
    QPainterPath path;
    path.arcMoveTo(square(from), start);
    path.arcTo(square(from), start, width);
    path.arcTo(square(to), start + width, -width);
    path.closeSubpath();
    return path;
}

} // namespace

int WindRoseView::legendWidth() const
{
    int widest = 0;
    for (int speedClass = 0; speedClass < windrose::classCount; ++speedClass) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(className(speedClass)));
    }
    return widest + fontMetrics().height() + 3 * margin;
}

/// The rose stands in what texts above, the legend at the side and the names of the rumbs leave.
WindRoseView::Place WindRoseView::place() const
{
    const double top = 2.0 * fontMetrics().lineSpacing() + 2 * margin;
    const double name = fontMetrics().height() + margin;
    const QRectF area(margin, top, width() - legendWidth() - 2 * margin, height() - top - margin);
    Place at;
    at.outer = std::max(20.0, std::min(area.width() / 2 - 1.6 * name, area.height() / 2 - name));
    at.inner = innerShare * at.outer;
    at.centre = area.center();
    return at;
}

QColor WindRoseView::classColour(int speedClass, bool isDark)
{
    const double step = double(speedClass) / (windrose::classCount - 1);
    const double saturation = isDark ? 0.75 - 0.55 * step : 0.30 + 0.65 * step;
    const double value = isDark ? 0.45 + 0.55 * step : 0.95 - 0.55 * step;
    return QColor::fromHsvF(0.57F, static_cast<float>(saturation), static_cast<float>(value));
}

void WindRoseView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setRenderHint(QPainter::Antialiasing);
    const Place at = place();
    quint32 largest = 0;
    for (int sector = 0; sector < windrose::sectorCount; ++sector) {
        largest = std::max(largest, m_counts.inSector(sector));
    }
    const double rim = rimShare(m_counts.share(largest));
    paintCompass(painter, at, rim);
    paintPetals(painter, at, rim);
    paintArrows(painter, at);
    paintTexts(painter);
    paintLegend(painter);
}

void WindRoseView::paintCompass(QPainter &painter, const Place &at, double rim) const
{
    const QColor muted = colours::mutedText(palette());
    QColor grid = muted;
    grid.setAlphaF(0.35F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(grid, 1));
    for (int sector = 0; sector < windrose::sectorCount; ++sector) {
        const double degrees = sector * windrose::sectorWidth;
        const bool isMain = sector % 4 == 0;
        painter.drawLine(
            onCircle(at.centre, isMain ? at.inner : at.outer - margin, degrees),
            onCircle(at.centre, at.outer, degrees));
    }
    const double half = (at.inner + at.outer) / 2;
    painter.drawEllipse(at.centre, half, half);
    painter.setPen(QPen(muted, 1));
    painter.drawEllipse(at.centre, at.outer, at.outer);
    painter.setPen(palette().color(QPalette::Text));
    for (int sector = 0; sector < windrose::sectorCount; sector += 2) {
        const bool isMain = sector % 4 == 0;
        QFont name = font();
        name.setBold(isMain);
        painter.setFont(name);
        const QPointF middle =
            onCircle(at.centre, at.outer + fontMetrics().height() * 0.75, sector * windrose::sectorWidth);
        const QSizeF room(4.0 * fontMetrics().height(), 1.2 * fontMetrics().height());
        painter.drawText(
            QRectF(middle - QPointF(room.width() / 2, room.height() / 2), room), Qt::AlignCenter,
            weathertext::rumb(sector));
    }
    painter.setFont(font());
    painter.setPen(muted);
    for (const auto &[radius, share] : {std::pair(half, rim / 2), std::pair(at.outer, rim)}) {
        const QPointF end = onCircle(at.centre, radius - 2, windrose::sectorWidth / 2);
        painter.drawText(end, valuetext::fixed(100 * share, 0) + u'%');
    }
}

void WindRoseView::paintPetals(QPainter &painter, const Place &at, double rim) const
{
    const auto radius = [&at, this, rim](quint32 count) {
        return at.inner + (at.outer - at.inner) * m_counts.share(count) / rim;
    };
    painter.setPen(QPen(palette().color(QPalette::Base), 0.8));
    for (int sector = 0; sector < windrose::sectorCount; ++sector) {
        quint32 below = 0;
        for (int speedClass = 0; speedClass < windrose::classCount; ++speedClass) {
            const quint32 count =
                m_counts.cells[static_cast<std::size_t>(sector)][static_cast<std::size_t>(speedClass)];
            if (count > 0) {
                const double width = windrose::sectorWidth * (0.35 + 0.1 * speedClass);
                painter.setBrush(classColour(speedClass, colours::isDark(palette())));
                painter.drawPath(
                    ringPart(at.centre, radius(below), radius(below + count), sector * windrose::sectorWidth, width));
            }
            below += count;
        }
    }
    painter.setPen(QPen(colours::mutedText(palette()), 1));
    painter.setBrush(palette().base());
    painter.drawEllipse(at.centre, at.inner, at.inner);
    if (m_counts.total() > 0) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(
            QRectF(at.centre - QPointF(at.inner, at.inner), QSizeF(2 * at.inner, 2 * at.inner)), Qt::AlignCenter,
            valuetext::fixed(100 * m_counts.share(m_counts.calm), 0) + u'%');
    }
}

/// The mean is an open triangle on the rim; the wind of now a full arrow over the compass. Both point where the air goes.
void WindRoseView::paintArrows(QPainter &painter, const Place &at) const
{
    const QColor text = palette().color(QPalette::Text);
    const double size = std::max(8.0, at.outer * 0.09);
    const auto triangle = [&at, size](double radius, double degrees) {
        const double half = 30 * size / (radius + size); // degrees: about as wide as long
        return QPolygonF(
            {onCircle(at.centre, radius, degrees), onCircle(at.centre, radius + size, degrees - half),
             onCircle(at.centre, radius + size, degrees + half)});
    };
    if (m_now.meanDirection) {
        painter.setPen(QPen(text, 1.5));
        painter.setBrush(palette().base());
        painter.drawPolygon(triangle(at.outer - size, *m_now.meanDirection));
    }
    if (m_now.direction) {
        painter.setPen(QPen(palette().color(QPalette::Base), 5));
        const QPointF tail = onCircle(at.centre, at.outer, *m_now.direction);
        const QPointF neck = onCircle(at.centre, at.inner + size, *m_now.direction);
        painter.drawLine(tail, neck);
        painter.setPen(QPen(text, 2.5));
        painter.drawLine(tail, neck);
        painter.setPen(QPen(palette().color(QPalette::Base), 1));
        painter.setBrush(text);
        painter.drawPolygon(triangle(at.inner + 2, *m_now.direction));
    }
}

void WindRoseView::paintTexts(QPainter &painter) const
{
    const auto speed = [](std::optional<double> value) { return valuetext::fixed(value, 1); };
    const int line = fontMetrics().lineSpacing();
    const QRect first(margin, margin, width() - 2 * margin, line);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(
        first, Qt::AlignLeft | Qt::AlignVCenter,
        tr("▲ now %1, %2 m/s").arg(weathertext::direction(m_now.direction), speed(m_now.speed)));
    painter.setFont(font());
    painter.drawText(
        first.translated(0, line), Qt::AlignLeft | Qt::AlignVCenter,
        tr("△ mean %1, %2 m/s; gust %3 m/s")
            .arg(weathertext::direction(m_now.meanDirection), speed(m_now.meanSpeed), speed(m_now.gust)));
}

void WindRoseView::paintLegend(QPainter &painter) const
{
    const int line = fontMetrics().lineSpacing() + 2;
    const int left = width() - legendWidth();
    int top = height() - margin - (windrose::classCount + 1) * line;
    const double box = fontMetrics().height() - 2;
    for (int speedClass = windrose::classCount - 1; speedClass >= 0; --speedClass, top += line) {
        // As wide as the parts of the petals are beside each other.
        const double width = box * (0.35 + 0.1 * speedClass) / 0.85;
        painter.setPen(QPen(colours::mutedText(palette()), 0.5));
        painter.setBrush(classColour(speedClass, colours::isDark(palette())));
        painter.drawRect(QRectF(left + (box - width) / 2, top + 2, width, box));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(
            QRect(left + int(box) + margin, top, this->width() - left - int(box) - margin, line),
            Qt::AlignLeft | Qt::AlignVCenter, className(speedClass));
    }
    painter.setPen(QPen(colours::mutedText(palette()), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(left + box / 2, top + line / 2.0), box / 2.5, box / 2.5);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(
        QRect(left + int(box) + margin, top, this->width() - left - int(box) - margin, line),
        Qt::AlignLeft | Qt::AlignVCenter, tr("calm"));
}

} // namespace gorizont
