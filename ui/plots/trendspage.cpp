#include "ui/plots/trendspage.h"

#include "ui/models/colours.h"
#include "ui/plots/cursorpair.h"
#include "ui/plots/curvechooser.h"
#include "ui/plots/rangeactions.h"
#include "ui/plots/trendplot.h"

#include <QComboBox>
#include <QTimer>

namespace gorizont {

namespace {

constexpr std::chrono::milliseconds edgePeriod(250); ///< the edge moves at most so often

} // namespace

TrendsPage::TrendsPage(SensorRegistry &registry, SeriesSource source, QWidget *parent, SeriesFeed::Clock clock)
    : QWidget(parent)
    , m_registry(registry)
    , m_clock(clock)
    , m_source(std::move(source))
    , m_feed(new SeriesFeed(std::move(clock), this))
{
    setObjectName(QStringLiteral("trendsPage"));
    build();
    connectParts();
    m_feed->setSource(m_source, true);
    restoreLast();
}

TrendsPage::~TrendsPage()
{
    keepLast();
}

void TrendsPage::connectParts()
{
    m_tick->setInterval(edgePeriod);
    connect(m_tick, &QTimer::timeout, this, &TrendsPage::advance);
    connect(&m_registry, &SensorRegistry::readingsChanged, m_feed, &SeriesFeed::append);
    connect(m_feed, &SeriesFeed::historyChanged, this, &TrendsPage::drawHistory);
    connect(m_feed, &SeriesFeed::liveChanged, this, &TrendsPage::drawLive);
    connect(m_feed, &SeriesFeed::waitingChanged, this, &TrendsPage::updateTexts);
    connect(&m_chooser->model(), &CurveModel::chosenChanged, this, &TrendsPage::applyCurves);
    connect(m_ranges, &RangeActions::chosen, this, &TrendsPage::applyRange);
    connect(m_now, &QAction::triggered, this, &TrendsPage::setFollowing);
    connect(m_plot, &TimePlot::spanChanged, this, &TrendsPage::applySpan);
    connect(m_plot, &TimePlot::endWanted, this, &TrendsPage::showEnd);
    connect(m_plot, &TimePlot::beginningWanted, this, &TrendsPage::showBeginning);
    connect(m_plot, &TimePlot::movedByHand, this, &TrendsPage::leaveEdge);
    connect(m_cursors, &CursorPair::moved, this, &TrendsPage::updateCursors);
    connect(&m_overview, &QFutureWatcherBase::finished, this, &TrendsPage::takeOverview);
}

/// Whoever zooms at the edge stays there; whoever leaves it is left alone.
void TrendsPage::leaveEdge()
{
    const TimeSpan shown = m_plot->span();
    const UtcTime now = m_clock();
    const bool isAtEdge = now >= shown.from && shown.to >= now - (shown.to - shown.from) / 100;
    if (m_isFollowing && !isAtEdge) {
        setFollowing(false);
    }
}

void TrendsPage::applyRange(std::chrono::seconds span)
{
    if (m_isFollowing) {
        follow(span);
        return;
    }
    const TimeSpan shown = m_plot->span();
    const UtcTime middle = shown.from + (shown.to - shown.from) / 2;
    showSpan({middle - span / 2, middle + span / 2});
}

void TrendsPage::setSource(SeriesSource source)
{
    m_source = std::move(source);
    if (!m_files) {
        m_feed->setSource(m_source, true);
        updateTexts();
    }
}

QList<SeriesKey> TrendsPage::curves() const
{
    return m_chooser->model().chosen();
}

void TrendsPage::showCurves(const QList<SeriesKey> &keys)
{
    m_chooser->model().setChosen(keys);
}

void TrendsPage::addSensor(int number)
{
    m_chooser->model().addSensor(number);
}

void TrendsPage::follow(std::chrono::seconds span)
{
    if (m_files) {
        showSpan({m_files->to - span, m_files->to});
        return;
    }
    const UtcTime now = m_clock();
    m_plot->setSpan({now - span, now});
    setFollowing(true);
}

void TrendsPage::showSpan(const TimeSpan &span)
{
    setFollowing(false);
    m_plot->setSpan(span);
}

void TrendsPage::setFollowing(bool isFollowing)
{
    m_isFollowing = isFollowing;
    m_now->setChecked(isFollowing);
    m_plot->setKeepsEnd(isFollowing);
    if (isFollowing) {
        const TimeSpan shown = m_plot->span();
        const UtcTime now = m_clock();
        m_plot->setSpan({now - (shown.to - shown.from), now});
    }
}

/// Moves the edge when that is a pixel at least.
void TrendsPage::advance()
{
    if (!m_isFollowing) {
        return;
    }
    const TimeSpan shown = m_plot->span();
    const std::chrono::microseconds length = shown.to - shown.from;
    const UtcTime now = m_clock();
    if (now - shown.to >= length / std::max(1, m_plot->plotWidth()) || now < shown.to) {
        m_plot->setSpan({now - length, now});
    }
}

void TrendsPage::applyCurves()
{
    m_drawn.clear();
    for (const SeriesKey &key : curves()) {
        const auto index = static_cast<std::size_t>(m_registry.indexOf(key.number));
        const CurveStyle style = curveStyle(static_cast<int>(m_drawn.size()), colours::isDark(palette()));
        m_drawn.append({key, plottext::curve(m_registry.sensors()[index].config, key.quantity), style});
    }
    m_plot->setCurves(m_drawn, m_unit);
    applySpan();
    drawHistory();
}

void TrendsPage::applySpan()
{
    const TimeSpan shown = m_plot->span();
    m_ranges->setShown(shown.to - shown.from);
    m_feed->want({curves(), shown.from, shown.to, m_plot->plotWidth()});
    draw();
}

void TrendsPage::drawHistory()
{
    for (const SeriesKey &key : curves()) {
        Series history = m_feed->history(key);
        history.key = key;
        m_plot->setSeries(history, m_feed->live(key));
    }
    draw();
}

void TrendsPage::drawLive(const QList<SeriesKey> &keys)
{
    if (!isVisible()) {
        return; // showEvent() draws all
    }
    for (const SeriesKey &key : keys) {
        m_plot->append(key, m_feed->live(key));
    }
    draw();
}

void TrendsPage::draw()
{
    m_plot->fitScales();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    updateTexts();
    updateCursors();
}

void TrendsPage::setUnit(TiltUnit unit)
{
    m_unit = unit;
    m_units->setCurrentIndex(unit == TiltUnit::Degrees ? 0 : 1);
    applyCurves();
}

void TrendsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_tick->start();
    drawHistory();
    advance();
}

/// The curves have other colours on a dark background.
void TrendsPage::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_plot) {
        applyCurves();
    }
}

void TrendsPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick->stop();
}

} // namespace gorizont
