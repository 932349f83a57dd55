#pragma once

#include "core/devices/usmisn/usmisnvalues.h"

#include <QWidget>

class QCheckBox;
class QDateTimeEdit;
class QGroupBox;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace gorizont {

/// Makes an УСМ-ИСН, or all on the line, a recorder and wakes it again (manual 002, 3.13 and 3.14). GUI thread.
class UsmRecorderPanel : public QWidget
{
    Q_OBJECT

public:
    explicit UsmRecorderPanel(QWidget *parent = nullptr);

    /// From \a now on, seconds since 1970.
    usmisn::Recording recording(qint64 now) const;
    bool isForAll() const; ///< a broadcast is wanted
    int wakeAddress() const; ///< a recorder answers no scan, so its address is typed
    void setWakeAddress(int address);

    void setControls(bool isReady, bool isShown);
    /// Per cent of the time that waking may take; empty: nobody is being woken.
    void showWaking(std::optional<int> percent);

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void chosen(); ///< something else may be pressed now
    void startWanted();
    void wakeWanted();
    void wakingStopped();

private:
    QGroupBox *makeStart();
    QGroupBox *makeWake();

    QCheckBox *m_forAll;
    QDateTimeEdit *m_first = nullptr;
    QSpinBox *m_period = nullptr;
    QSpinBox *m_delay = nullptr;
    QPushButton *m_start = nullptr;
    QSpinBox *m_address = nullptr;
    QProgressBar *m_progress = nullptr;
    QPushButton *m_wake = nullptr;
    bool m_isWaking = false;
};

} // namespace gorizont
