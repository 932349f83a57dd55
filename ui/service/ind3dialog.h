#pragma once

#include "core/devices/ind3/ind3service.h"
#include "ui/service/servicedialog.h"

namespace gorizont {

class Ind3Form;
class NewAddressDialog;

/// «Настройка датчика ИН-Д3» (manual 000, section 8). Every setting is a step of its own, so that leaving is heard between
/// any two. GUI thread.
class Ind3Dialog : public ServiceDialog
{
    Q_OBJECT

public:
    explicit Ind3Dialog(const ServicePort &port, QWidget *parent = nullptr);

protected:
    ScanPanel::Probe probe() const override;
    void showSensor() override;
    void readLive() override;
    QString unfinished(bool isLeaving) const override;
    void updateControls() override;

private:
    ind3::Service service() const;
    void read(const QString &before);
    QString readText(int to, const Result<ind3::Settings> &settings) const;
    void apply();
    void writeNext();
    void take(const ind3::Changes &change, const Result<QList<ind3::Outcome>> &outcome);
    void finishWriting();
    void askNewAddress();
    void changeAddress(int newAddress);
    void onAddressChanged(int from, int to, const Result<void> &changed);

    QPushButton *m_change;
    QComboBox *m_protocols;
    Ind3Form *m_form;
    QPushButton *m_apply;
    QPointer<NewAddressDialog> m_newAddress;

    QList<ind3::Changes> m_toWrite; ///< one setting each
    QStringList m_report; ///< sentences about those that were written or not
    bool m_isGood = true; ///< all of them were written
    int m_dialect = 0; ///< index into the list of protocols
};

} // namespace gorizont
