#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/plots/seriesfeed.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QTimer;
class QToolBar;

namespace gorizont {

class RangeActions;

/// One sensor over a span of time that ends now or lies in the past: what the pages of the hodograph and of the waveform
/// share. They draw; the sensor, the span and the questions to the source are here. GUI thread.
class SpanPage : public QWidget
{
    Q_OBJECT

public:
    void setSource(SeriesSource source, bool isLive = true);

    void showSensor(int number);
    int sensor() const; ///< N; 0: there is none
    void follow(std::chrono::seconds span);
    void showSpan(const TimeSpan &span);
    TimeSpan span() const { return m_span; }
    bool isFollowing() const { return m_isFollowing; }

protected:
    /// Both quantities belong to every sensor that is offered. \a width of the questions, pixels; 0: full rate.
    SpanPage(
        SensorRegistry &registry, SeriesSource source, std::pair<Quantity, Quantity> quantities, int width,
        QWidget *parent, SeriesFeed::Clock clock);

    /// Lays \a content out below the tool bar.
    void setContent(QWidget *content, const QString &withoutSensors, const QString &withoutValues);
    QToolBar *bar() const { return m_bar; }

    /// All that is known, which may reach beyond the span.
    Series first() const;
    Series second() const;
    /// Draws first() and second() over span().
    virtual void draw() = 0;
    void setNote(const QString &note); ///< below the plot

    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void buildBar(const SensorRegistry &registry);
    void applyRange(std::chrono::seconds span);
    void ask();
    void advance();
    void redraw();
    SeriesKey key(Quantity quantity) const { return {sensor(), quantity}; }

    const SeriesFeed::Clock m_clock;
    const std::pair<Quantity, Quantity> m_quantities;
    const int m_width;
    SeriesFeed *m_feed;
    QToolBar *m_bar;
    QComboBox *m_sensors;
    RangeActions *m_ranges;
    QAction *m_now = nullptr;
    QLabel *m_hint = nullptr;
    QLabel *m_state;
    QTimer *m_tick;
    QString m_withoutSensors;
    QString m_withoutValues;
    TimeSpan m_span;
    bool m_isFollowing = true;
};

/// What of \a series begins within \a span.
Series trimmed(Series series, const TimeSpan &span);

} // namespace gorizont
