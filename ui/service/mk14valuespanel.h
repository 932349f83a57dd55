#pragma once

#include "core/values/weather.h"
#include "ui/weather/precipitation.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace gorizont {

class PrecipitationModel;
class TableView;
class WeatherModel;

/// What a weather station answers to one of its data commands, asked by hand. GUI thread.
class Mk14ValuesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit Mk14ValuesPanel(QWidget *parent = nullptr);

    int command() const; ///< 1…8
    /// \a now: seconds of the station.
    void showWeather(const Weather &weather, precipitation::StationClock clock, qint64 now);
    void clear();
    void setMayRead(bool mayRead);

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void readWanted();

private:
    QComboBox *m_commands;
    QPushButton *m_read;
    WeatherModel *m_model;
    TableView *m_table;
    QLabel *m_inputs;
    PrecipitationModel *m_rain;
    TableView *m_rainTable;
};

} // namespace gorizont
