#pragma once

#include "core/values/lineconfig.h"

#include <QGroupBox>

class QHBoxLayout;
class QPushButton;

namespace gorizont {

/// <COM-порт>: what the ini says of the port, and the button that gives it back to polling while the window stays, or takes
/// it again (manual 000, section 8.5). GUI thread.
class PortGroup : public QGroupBox
{
    Q_OBJECT

public:
    explicit PortGroup(const LineConfig &line, QWidget *parent = nullptr);

    void setInService(bool isInService);
    void setButtonEnabled(bool isEnabled);

Q_SIGNALS:
    void toggleWanted();

private:
    void addSerial(const LineConfig &line, QHBoxLayout &layout);

    QPushButton *m_button;
};

} // namespace gorizont
