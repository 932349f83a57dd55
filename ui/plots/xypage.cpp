#include "ui/plots/xypage.h"

#include "ui/plots/plotlook.h"
#include "ui/plots/plottime.h"
#include "ui/plots/plotting.h"
#include "ui/plots/timeticker.h"

#include <QComboBox>
#include <QToolBar>

#include <limits>

namespace gorizont {

namespace {

constexpr int parts = 32; ///< colours
constexpr int mostPoints = 3000; ///< buckets that are asked for
constexpr double air = 0.12; ///< around the way, of its size
constexpr double leastSize = 1; ///< arc-seconds that a plot shows

/// From blue through green to yellow: monotone in lightness, so that it is read without colours too.
QCPColorGradient timeGradient()
{
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorStopAt(0.0, QColor(0x2c, 0x2a, 0x7e));
    gradient.setColorStopAt(0.35, QColor(0x1f, 0x77, 0x8f));
    gradient.setColorStopAt(0.7, QColor(0x3f, 0xb0, 0x6a));
    gradient.setColorStopAt(1.0, QColor(0xe0, 0xb8, 0x1c));
    return gradient;
}

} // namespace

XyPage::XyPage(SensorRegistry &registry, SeriesSource source, QWidget *parent, SeriesFeed::Clock clock)
    : SpanPage(registry, std::move(source), {Quantity::TiltX, Quantity::TiltY}, mostPoints, parent, std::move(clock))
    , m_plot(new QCustomPlot(this))
{
    setObjectName(QStringLiteral("xyPage"));
    buildPlot();
    m_start = addMark(tr("start"), true);
    m_end = addMark(tr("end"), false);
    dress();
    m_plot->installEventFilter(this);
    auto *units = new QComboBox(bar());
    units->setObjectName(QStringLiteral("tiltUnit"));
    units->setToolTip(tr("In what angles are drawn"));
    units->addItems({tr("degrees"), tr("arc-seconds")});
    units->setCurrentIndex(1);
    bar()->addWidget(units);
    connect(units, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_unit = index == 0 ? TiltUnit::Degrees : TiltUnit::ArcSeconds;
        draw();
    });
    setContent(
        m_plot, tr("No sensor of the configuration measures tilt."),
        tr("There are no angles in this span. Choose a longer span or another sensor."));
}

void XyPage::buildPlot()
{
    m_plot->setObjectName(QStringLiteral("xyPlot"));
    m_plot->setAccessibleName(tr("Way of the axis"));
    m_plot->setFocusPolicy(Qt::StrongFocus);
    setFocusProxy(m_plot);
    const QCPColorGradient gradient = timeGradient();
    for (int i = 0; i < parts; ++i) {
        auto *part = new QCPCurve(m_plot->xAxis, m_plot->yAxis);
        part->setPen(QPen(QColor::fromRgb(QCPColorGradient(gradient).color((i + 0.5) / parts, QCPRange(0, 1))), 1.5));
        m_parts.append(part);
    }
    m_times = new QCPColorScale(m_plot);
    m_plot->plotLayout()->addElement(0, 1, m_times);
    m_times->setType(QCPAxis::atRight);
    m_times->setGradient(gradient);
    m_times->axis()->setTicker(QSharedPointer<TimeTicker>::create());
    m_times->setBarWidth(12);
    m_plot->xAxis->setNumberPrecision(7);
    m_plot->yAxis->setNumberPrecision(7);
    connect(m_plot, &QCustomPlot::afterLayout, this, &XyPage::scaleEqually);
}

XyPage::Mark XyPage::addMark(const QString &name, bool isStart)
{
    Mark mark{new QCPItemTracer(m_plot), new QCPItemText(m_plot)};
    mark.point->setStyle(isStart ? QCPItemTracer::tsCircle : QCPItemTracer::tsSquare);
    mark.point->setSize(10);
    mark.name->setText(name);
    mark.name->setPositionAlignment(isStart ? Qt::AlignRight | Qt::AlignBottom : Qt::AlignLeft | Qt::AlignTop);
    mark.name->position->setParentAnchor(mark.point->position);
    mark.name->position->setType(QCPItemPosition::ptAbsolute);
    mark.name->position->setCoords(isStart ? -7 : 7, isStart ? -3 : 3);
    return mark;
}

/// In the colours of the desktop, which may change while the program runs.
void XyPage::dress()
{
    const QColor text = palette().color(QPalette::Text);
    plotlook::dress(*m_plot);
    plotlook::dress(*m_times->axis(), *m_plot);
    for (const Mark &mark : {m_start, m_end}) {
        mark.point->setPen(QPen(text, 2));
        mark.name->setColor(text);
    }
    m_start.point->setBrush(palette().color(QPalette::Base));
    m_end.point->setBrush(text);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

/// Of the plot: it gets a palette after its page.
bool XyPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        dress();
    }
    return SpanPage::eventFilter(watched, event);
}

void XyPage::place(const Mark &mark, const QList<HodographPoint> &points, qsizetype at)
{
    mark.point->setVisible(!points.isEmpty());
    mark.name->setVisible(!points.isEmpty());
    if (!points.isEmpty()) {
        mark.point->position->setCoords(drawn(points.at(at).place));
    }
}

QPointF XyPage::drawn(const QPointF &place) const
{
    return place * plottext::scaleOf(Quantity::TiltX, m_unit);
}

void XyPage::drawWay(const QList<HodographPoint> &points)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    QList<QVector<QCPCurveData>> drawnParts(parts);
    const double begin = toKey(span().from);
    const double length = std::max(1e-3, toKey(span().to) - begin);
    int before = -1;
    for (const HodographPoint &point : points) {
        const double key = toKey(point.time);
        const int part = std::clamp(static_cast<int>((key - begin) / length * parts), 0, parts - 1);
        const QPointF place = drawn(point.place);
        if (!point.isJoined) {
            drawnParts[part].append({key - 1e-6, nothing, nothing});
        } else if (part != before) {
            drawnParts[before].append({key, place.x(), place.y()}); // a colour ends where the next begins
        }
        drawnParts[part].append({key, place.x(), place.y()});
        before = part;
    }
    for (int i = 0; i < parts; ++i) {
        m_parts[i]->data()->set(drawnParts.at(i), true);
    }
}

void XyPage::draw()
{
    const QList<HodographPoint> points = hodograph(trimmed(first(), span()), trimmed(second(), span()));
    m_plot->xAxis->setLabel(QStringLiteral("Mx, ") + plottext::unitOf(ValueAxis::Tilt, m_unit));
    m_plot->yAxis->setLabel(QStringLiteral("My, ") + plottext::unitOf(ValueAxis::Tilt, m_unit));
    m_times->setDataRange(QCPRange(toKey(span().from), toKey(span().to)));
    QPolygonF way;
    for (const HodographPoint &point : points) {
        way.append(drawn(point.place));
    }
    m_bounds = way.boundingRect();
    drawWay(points);
    place(m_start, points, 0);
    place(m_end, points, points.size() - 1);
    scaleEqually();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    setNote({});
}

/// A pixel is the same angle on both axes; the way fits in. The size of the plot is that of its last layout.
void XyPage::scaleEqually()
{
    const QSize size = m_plot->axisRect()->size();
    if (size.isEmpty()) {
        return;
    }
    const double least = leastSize * plottext::scaleOf(Quantity::TiltX, m_unit);
    const double anglePerPixel = (1 + 2 * air)
        * std::max({m_bounds.width() / size.width(), m_bounds.height() / size.height(), least / size.width()});
    const auto fit = [anglePerPixel](QCPAxis *axis, double middle, int pixels) {
        const double half = anglePerPixel * pixels / 2;
        const bool isOther = std::abs(axis->range().size() - 2 * half) > 1e-6 * half
            || std::abs(axis->range().center() - middle) > 1e-6 * half;
        axis->setRange(middle - half, middle + half);
        return isOther;
    };
    const bool isWider = fit(m_plot->xAxis, m_bounds.center().x(), size.width());
    const bool isHigher = fit(m_plot->yAxis, m_bounds.center().y(), size.height());
    if (isWider || isHigher) {
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace gorizont
