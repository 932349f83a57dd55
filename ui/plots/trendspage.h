#pragma once

#include "core/history/historysource.h"
#include "core/registry/sensorregistry.h"
#include "ui/plots/plottext.h"
#include "ui/plots/seriesfeed.h"
#include "ui/plots/trendlayouts.h"

#include <QFutureWatcher>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QTimer;
class QToolBar;

namespace gorizont {

class CursorPair;
class CursorPanel;
class CurveChooser;
class RangeActions;
class TrendPlot;
struct TrendCurve;

/// The page <Графики>: what sensors said over time, from the last minutes to the last year. History comes from a source,
/// the live edge from the registry; nothing here waits for either. GUI thread.
class TrendsPage : public QWidget
{
    Q_OBJECT

public:
    enum class Export : quint8 { Png, Pdf, ExcelCsv, IsoCsv };

    /// \a source may be null: then only what comes from now on is drawn. The registry outlives the page.
    TrendsPage(
        SensorRegistry &registry, SeriesSource source, QWidget *parent = nullptr, SeriesFeed::Clock clock = utcNow);
    ~TrendsPage() override;

    void setSource(SeriesSource source);

    QList<SeriesKey> curves() const;
    void showCurves(const QList<SeriesKey> &keys);
    /// Adds what an operator wants to see first of a sensor.
    void addSensor(int number);

    /// Shows the text and binary files of a folder History instead of the archive, until somebody goes back.
    void openOldFiles(const QString &path);
    void closeOldFiles();
    /// m/s², [Common] Gravity: what one unit of the binary files is.
    void setGravity(double gravity) { m_gravity = gravity; }

    /// The span ends now and moves on with the clock.
    void follow(std::chrono::seconds span);
    void showSpan(const TimeSpan &span);
    bool isFollowing() const { return m_isFollowing; }

    /// Writes what is seen; false: the file cannot be written.
    bool exportTo(const QString &path, Export form);
    /// Keeps curves and span under a name; what had it before goes.
    void keepLayout(const QString &name);
    void applyLayout(const TrendLayout &layout);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void build();
    void buildToolBar(QToolBar *bar);
    void buildMenus(QToolBar *bar);
    void connectParts();
    void leaveEdge();
    void applyRange(std::chrono::seconds span);
    void applyCurves();
    void applySpan();
    void advance();
    void drawHistory();
    void drawLive(const QList<SeriesKey> &keys);
    void draw();
    void setFollowing(bool isFollowing);
    void setUnit(TiltUnit unit);
    void updateTexts();
    void updateHint();
    void showCursors(bool isShown);
    void updateCursors();

    void askOldFiles();
    void takeOverview();
    void showOldFiles(const QString &path, const TimeSpan &span, SeriesSource source);
    void showBeginning();
    void showEnd();
    void askExport(Export form);
    void tell(const QString &text);
    TrendLayout layoutNow(const QString &name) const;
    void askLayoutName();
    void fillLayouts(QMenu *menu);
    void restoreLast();
    void keepLast() const;

    SensorRegistry &m_registry;
    const SeriesFeed::Clock m_clock;
    SeriesSource m_source; ///< the archive
    SeriesFeed *m_feed;
    CurveChooser *m_chooser = nullptr;
    TrendPlot *m_plot = nullptr;
    QList<TrendCurve> m_drawn;
    CursorPair *m_cursors = nullptr;
    CursorPanel *m_readout = nullptr;
    RangeActions *m_ranges = nullptr;
    QAction *m_now = nullptr;
    QComboBox *m_units = nullptr;
    QLabel *m_hint = nullptr; ///< over an empty plot
    QLabel *m_state = nullptr; ///< below it
    QTimer *m_tick = nullptr;
    TiltUnit m_unit = TiltUnit::Degrees;
    bool m_isFollowing = true;
    QAction *m_archive = nullptr; ///< goes back from old files
    std::optional<TimeSpan> m_files; ///< of the old files that are open; empty: none are
    QString m_filesPath;
    double m_gravity = 9.81347;
    HistoryFolder m_folder; ///< that is being looked into
    QFutureWatcher<HistoryOverview> m_overview;
};

} // namespace gorizont
