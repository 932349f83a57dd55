#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/weather/precipitation.h"
#include "ui/weather/stationfilesmodel.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QTimer;

namespace gorizont {

class InputLamps;
class PrecipitationModel;
class PropertyModel;
class TableView;
class WeatherModel;
class WindLog;
class WindRoseView;

/// The tab <Погода>: what a МК-14 measures: wind as a rose and as numbers, its parameters, its digital inputs, and when it rained.
/// Gathers the winds from the start of the program; draws at most four times a second and only while it is seen. GUI thread.
class WeatherPage : public QWidget
{
    Q_OBJECT

public:
    using Clock = std::function<QDateTime()>;

    /// The registry outlives the page. \a now: the wall clock of this computer.
    explicit WeatherPage(
        const SensorRegistry &registry, QWidget *parent = nullptr, Clock now = &QDateTime::currentDateTime);

    void showStation(int number);
    int station() const; ///< N; 0: there is none

    /// What is wrong with the files of station N \a number, which runs in this program; shown with it.
    void setFileComplaints(int number, const QList<StationFileComplaint> &complaints);

    /// Draws the station by its last reading; by itself while the page is seen and something has changed.
    void refresh();

    /// Whether a site has a station to show.
    static bool hasStation(const SensorRegistry &registry);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void build();
    QWidget *makeBar();
    QWidget *makeNumbers();
    void choose();
    void tick();
    const SensorRegistry::Sensor *sensor() const; ///< null: none
    LineState lineState(const SensorRegistry::Sensor &sensor) const;
    void showParameters(const SensorRegistry::Sensor &sensor, const Weather *shown);
    void showRain(const SensorRegistry::Sensor &sensor);
    void showWind(int number, const Weather *shown);
    void showAge();
    QString statusOf(const SensorRegistry::Sensor &sensor, const Weather *shown) const;

    const SensorRegistry &m_registry;
    const Clock m_now;
    WindLog *m_log;
    QComboBox *m_stations;
    QComboBox *m_spans;
    QLabel *m_status;
    QLabel *m_age;
    WindRoseView *m_rose;
    PropertyModel *m_wind;
    TableView *m_windTable;
    InputLamps *m_lamps;
    QLabel *m_inputs;
    PrecipitationModel *m_rain;
    TableView *m_rainTable;
    WeatherModel *m_parameters;
    TableView *m_table;
    StationFilesModel *m_files;
    TableView *m_filesTable; ///< hidden while there is nothing to complain about
    QHash<int, QList<StationFileComplaint>> m_complaints; ///< N → of its files
    QTimer *m_tick; ///< while the page is seen
    bool m_isDirty = true; ///< something came since the last drawing
};

} // namespace gorizont
