#pragma once

#include "core/devices/mk14/mk14options.h"
#include "core/devices/mk14/mk14service.h"
#include "ui/service/servicedialog.h"
#include "ui/weather/precipitation.h"

#include <QMap>

namespace gorizont {

class Mk14Form;

/// «Настройка метеостанции МК-14» (manual 004, sections 3.6 and 4): asks with any command; outputs, clock and settings files as
/// explicit actions. A request switches the outputs to what it carries, so only stations of the ini are asked, whose word
/// is known: the scan knows no others. GUI thread.
class Mk14Dialog : public ServiceDialog
{
    Q_OBJECT

public:
    explicit Mk14Dialog(const ServicePort &port, QWidget *parent = nullptr);

protected:
    ScanPanel::Probe probe() const override;
    void showSensor() override;
    void readLive() override; ///< the clock of the window; nobody is asked
    QString unfinished(bool isLeaving) const override;
    void updateControls() override;

private:
    struct Shown ///< of a station
    {
        Weather weather;
        quint32 outputs = 0;
    };

    mk14::Service service() const;
    precipitation::StationClock clock() const;
    void forget();
    void readNow();
    void showRead(int to, const Result<Shown> &read);

    void askOutputs();
    void setOutputs(quint32 word);
    void askTime();
    void setTime();
    void chooseFile();
    void askFile();
    void sendFile(const QByteArray &name, const QByteArray &file);
    void begin(const QString &what); ///< writes \a what
    void end(int to, bool isGood, const QString &text);

    Mk14Form *m_form;
    QMap<int, mk14::Options> m_options; ///< of the stations of the port, by address
    bool m_isShown = false; ///< the station answered
};

} // namespace gorizont
