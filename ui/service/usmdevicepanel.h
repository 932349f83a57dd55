#pragma once

#include "core/devices/usmisn/usmisnservice.h"

#include <QWidget>

class QCheckBox;
class QGroupBox;
class QLabel;
class QPushButton;

namespace gorizont {

/// What an УСМ-ИСН says of itself, and what it measures now (manual 002, 3.1 – 3.6 and 3.11). GUI thread.
class UsmDevicePanel : public QWidget
{
    Q_OBJECT

public:
    explicit UsmDevicePanel(QWidget *parent = nullptr);

    void showIdentity(const usmisn::Identity &identity);
    void clear();
    /// Empty: it is being measured.
    void showValue(int channel, const std::optional<Result<usmisn::Value>> &value);
    void setMayMeasure(bool mayMeasure);
    bool isStored() const; ///< a measurement goes into the memory of the device, too

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void measureWanted();

private:
    QGroupBox *makeIdentity();
    QGroupBox *makeMeasuring();

    QLabel *m_serial = nullptr;
    QLabel *m_type = nullptr;
    QLabel *m_program = nullptr;
    QLabel *m_calibratedOn = nullptr;
    QLabel *m_calibrations = nullptr;
    QLabel *m_channels = nullptr;
    QLabel *m_x = nullptr;
    QLabel *m_y = nullptr;
    QCheckBox *m_store = nullptr;
    QPushButton *m_measure = nullptr;
};

} // namespace gorizont
