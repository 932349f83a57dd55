#include "ui/plots/spanpage.h"

#include "ui/models/statetext.h"
#include "ui/plots/plottext.h"
#include "ui/plots/rangeactions.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace gorizont {

namespace {

constexpr std::chrono::seconds edgePeriod(1);
constexpr std::chrono::minutes firstSpan(10);
constexpr std::chrono::seconds longestInBuckets = std::chrono::years(1);
constexpr std::chrono::seconds longestAtFullRate = std::chrono::days(1); ///< a day of samples is what a plot can hold

bool hasBoth(const SensorConfig &sensor, const std::pair<Quantity, Quantity> &quantities)
{
    const QList<Quantity> known = quantitiesOf(sensor);
    return known.contains(quantities.first) && known.contains(quantities.second);
}

} // namespace

SpanPage::SpanPage(
    SensorRegistry &registry, SeriesSource source, std::pair<Quantity, Quantity> quantities, int width, QWidget *parent,
    SeriesFeed::Clock clock)
    : QWidget(parent)
    , m_clock(clock)
    , m_quantities(quantities)
    , m_width(width)
    , m_feed(new SeriesFeed(std::move(clock), this))
    , m_bar(new QToolBar(this))
    , m_sensors(new QComboBox(m_bar))
    , m_ranges(new RangeActions(this, width == 0 ? longestAtFullRate : longestInBuckets))
    , m_state(new QLabel(this))
    , m_tick(new QTimer(this))
{
    buildBar(registry);
    m_state->setObjectName(QStringLiteral("spanState"));
    m_state->setWordWrap(true);
    m_state->setContentsMargins(6, 2, 6, 2);
    m_feed->setSource(std::move(source), true);
    m_span = {m_clock() - firstSpan, m_clock()};
    m_tick->setInterval(edgePeriod);
    connect(m_tick, &QTimer::timeout, this, &SpanPage::advance);
    connect(&registry, &SensorRegistry::readingsChanged, m_feed, &SeriesFeed::append);
    connect(m_feed, &SeriesFeed::historyChanged, this, &SpanPage::redraw);
    connect(m_feed, &SeriesFeed::waitingChanged, this, &SpanPage::redraw);
}

void SpanPage::buildBar(const SensorRegistry &registry)
{
    m_bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_sensors->setObjectName(QStringLiteral("spanSensor"));
    m_sensors->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_sensors->setMinimumContentsLength(24);
    m_sensors->setAccessibleName(tr("Sensor"));
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        if (hasBoth(sensor.config, m_quantities)) {
            m_sensors->addItem(statetext::sensorTitle(sensor.config), sensor.config.number);
        }
    }
    m_bar->addWidget(m_sensors);
    m_bar->addActions(m_ranges->actions());
    m_now = m_bar->addAction(tr("Now"));
    m_now->setObjectName(QStringLiteral("followAction"));
    m_now->setCheckable(true);
    m_now->setChecked(true);
    m_now->setToolTip(tr("The span ends at the present moment and moves on with it"));
    connect(m_sensors, &QComboBox::currentIndexChanged, this, &SpanPage::ask);
    connect(m_ranges, &RangeActions::chosen, this, &SpanPage::applyRange);
    connect(m_now, &QAction::triggered, this, [this](bool isNow) {
        m_isFollowing = isNow;
        advance();
    });
}

void SpanPage::setContent(QWidget *content, const QString &withoutSensors, const QString &withoutValues)
{
    m_withoutSensors = withoutSensors;
    m_withoutValues = withoutValues;
    m_hint = new QLabel(this);
    m_hint->setObjectName(QStringLiteral("spanHint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto *over = new QGridLayout; // the hint lies over the content
    over->setContentsMargins(0, 0, 0, 0);
    over->addWidget(content, 0, 0);
    over->addWidget(m_hint, 0, 0);
    m_hint->raise();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addLayout(over, 1);
    layout->addWidget(m_state);
    ask();
}

void SpanPage::setSource(SeriesSource source, bool isLive)
{
    m_feed->setSource(std::move(source), isLive);
}

void SpanPage::showSensor(int number)
{
    if (const int index = m_sensors->findData(number); index >= 0) {
        m_sensors->setCurrentIndex(index);
    }
}

int SpanPage::sensor() const
{
    return m_sensors->currentData().toInt();
}

void SpanPage::follow(std::chrono::seconds span)
{
    m_isFollowing = true;
    m_now->setChecked(true);
    m_span = {m_clock() - span, m_clock()};
    ask();
}

void SpanPage::showSpan(const TimeSpan &span)
{
    m_isFollowing = false;
    m_now->setChecked(false);
    m_span = span;
    ask();
}

/// Of a span in the past, the end stays.
void SpanPage::applyRange(std::chrono::seconds span)
{
    if (m_isFollowing) {
        follow(span);
    } else {
        showSpan({m_span.to - span, m_span.to});
    }
}

void SpanPage::ask()
{
    m_ranges->setShown(m_span.to - m_span.from);
    if (sensor() > 0) {
        m_feed->want({{key(m_quantities.first), key(m_quantities.second)}, m_span.from, m_span.to, m_width});
    }
    redraw();
}

void SpanPage::advance()
{
    if (m_isFollowing) {
        const UtcTime now = m_clock();
        m_span = {now - (m_span.to - m_span.from), now};
        ask();
    }
}

Series trimmed(Series series, const TimeSpan &span)
{
    series.buckets.removeIf(
        [&span](const SeriesBucket &bucket) { return bucket.from < span.from || bucket.from >= span.to; });
    return series;
}

Series SpanPage::first() const
{
    return m_feed->whole(key(m_quantities.first));
}

Series SpanPage::second() const
{
    return m_feed->whole(key(m_quantities.second));
}

void SpanPage::redraw()
{
    if (!m_hint) {
        return;
    }
    draw();
    const Series known = first();
    const bool hasValues =
        std::any_of(known.buckets.cbegin(), known.buckets.cend(), [this](const SeriesBucket &bucket) {
            return bucket.from >= m_span.from && bucket.from < m_span.to && bucket.valid > 0;
        });
    m_hint->setText(sensor() == 0 ? m_withoutSensors : m_withoutValues);
    m_hint->setVisible(sensor() == 0 || (!hasValues && !m_feed->isWaiting()));
}

void SpanPage::setNote(const QString &note)
{
    const QString seen = tr("%1 – %2").arg(plottext::moment(m_span.from), plottext::moment(m_span.to));
    if (m_feed->hasFailed()) {
        m_state->setText(tr("The archive does not answer. The journal says why."));
    } else if (m_feed->isWaiting() && first().buckets.isEmpty()) {
        m_state->setText(tr("Reading…"));
    } else {
        m_state->setText(note.isEmpty() ? seen : seen + QStringLiteral("   ") + note);
    }
}

void SpanPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_tick->start();
    advance();
}

void SpanPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick->stop();
}

} // namespace gorizont
