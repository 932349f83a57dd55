#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/plots/plottext.h"
#include "ui/plots/seriesfeed.h"

#include <QWidget>

class QLabel;
class QTimer;
class QToolBar;

namespace gorizont {

class CurveChooser;
class RangeActions;
class TrendPlot;

/// The page <Графики>: what sensors said over time, from the last minutes to the last year. History comes from a source,
/// the live edge from the registry; nothing here waits for either. GUI thread.
class TrendsPage : public QWidget
{
    Q_OBJECT

public:
    /// \a source may be null: then only what comes from now on is drawn. The registry outlives the page.
    TrendsPage(
        SensorRegistry &registry, SeriesSource source, QWidget *parent = nullptr, SeriesFeed::Clock clock = utcNow);
    ~TrendsPage() override;

    void setSource(SeriesSource source);

    QList<SeriesKey> curves() const;
    void showCurves(const QList<SeriesKey> &keys);
    /// Adds what an operator wants to see first of a sensor.
    void addSensor(int number);

    /// The span ends now and moves on with the clock.
    void follow(std::chrono::seconds span);
    void showSpan(const TimeSpan &span);
    bool isFollowing() const { return m_isFollowing; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void build();
    void buildToolBar(QToolBar *bar);
    void connectParts();
    void applyCurves();
    void applySpan();
    void advance();
    void drawHistory();
    void drawLive(const QList<SeriesKey> &keys);
    void draw();
    void setFollowing(bool isFollowing);
    void setUnit(TiltUnit unit);
    void updateTexts();

    SensorRegistry &m_registry;
    const SeriesFeed::Clock m_clock;
    SeriesSource m_source; ///< the archive
    SeriesFeed *m_feed;
    CurveChooser *m_chooser = nullptr;
    TrendPlot *m_plot = nullptr;
    RangeActions *m_ranges = nullptr;
    QAction *m_now = nullptr;
    QLabel *m_hint = nullptr; ///< over an empty plot
    QLabel *m_state = nullptr; ///< below it
    QTimer *m_tick = nullptr;
    TiltUnit m_unit = TiltUnit::Degrees;
    bool m_isFollowing = true;
};

} // namespace gorizont
