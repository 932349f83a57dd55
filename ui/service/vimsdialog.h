#pragma once

#include "core/devices/lvims/lvimsservice.h"
#include "ui/service/servicedialog.h"

namespace gorizont {

class VimsForm;

/// «Настройка модуля L-VIMS» (manual 003, section 2.4). Its modules are those of the port: there is nothing to scan. What takes
/// long is made of single exchanges. GUI thread.
class VimsDialog : public ServiceDialog
{
    Q_OBJECT

public:
    explicit VimsDialog(const ServicePort &port, QWidget *parent = nullptr);

protected:
    void findSensors() override;
    ScanPanel::Probe probe() const override;
    void showSensor() override;
    void readLive() override {} ///< what is shown changes only when somebody changes it
    QString unfinished(bool isLeaving) const override;
    void updateControls() override;

private:
    using Image = QList<quint16>;
    /// What a module is told; each has a button, a warning and a line in the journal of its own.
    struct Order
    {
        QString what; ///< `settings applied`
        std::function<Result<void>(lvims::Service &, Line &)> give;
        bool cutsOff = false; ///< no answer may come any more
    };

    const SensorConfig &module() const; ///< that is shown
    void connectForm();
    void forget();

    void read(const QString &before);
    void readMore(int run, const lvims::Register &set, const Image &values);
    void takeSettings(int run, const lvims::Register &set, const Result<Image> &read);
    void endReading(const QString &text);

    void askWrite();
    void write();
    void writeNext(const QList<lvims::SettingPiece> &left, qsizetype total);
    void endWriting(const Result<lvims::SettingErrors> &errors, const Result<void> &written);
    void ask(const QString &question, const QString &yes, const Order &order);
    void askApply();
    void askFlash();
    void askReload();
    void askRestart();
    void give(const Order &order);
    void checkOrder(const Order &order, const Result<void> &given);
    void restart();

    void openFile();
    void takeFile(const QString &path);
    void saveFile();

    VimsForm *m_form;
    /// Of the module that is shown; used in the thread of the line only, where each exchange gets a number of its own.
    std::shared_ptr<lvims::Service> m_service;
    std::optional<lvims::Identity> m_identity; ///< likewise; empty: it was not read
    Image m_inUse; ///< CUR; empty: not read
    Image m_prepared; ///< MUT; empty: not read
    QString m_before; ///< to be said with what the reading brings
    int m_run = 0; ///< answers to an earlier reading are not for this one
};

} // namespace gorizont
