#pragma once

#include "core/devices/and3/and3service.h"
#include "core/values/lineconfig.h"

#include <QWidget>

class QComboBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace gorizont {

/// <Параметры обмена>, <Данные> and <Система> of an АН-Д3 (manual 000, sections 9.8 – 9.11). GUI thread.
class And3Form : public QWidget
{
    Q_OBJECT

public:
    /// Puts the list of \a addresses in its place.
    explicit And3Form(QComboBox *addresses, QWidget *parent = nullptr);

    void showSettings(const and3::Settings &settings);
    void showValues(const std::optional<and3::ComplexRead> &values); ///< empty: it did not answer
    void clear();
    bool isShown() const { return m_isShown; } ///< a sensor was read

    /// The addresses to choose from, nothing chosen.
    void offer(const LineConfig &line, const QList<int> &free);
    int newAddress() const; ///< 0: none is chosen
    void setControls(bool mayChoose, bool mayWrite, bool mayReset);
    /// Per cent of the time that a restart takes; empty: none is waited for.
    void showRestart(std::optional<int> percent);

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void chosen();
    void writeWanted();
    void resetWanted();

private:
    QGroupBox *makeExchange(QComboBox *addresses);
    QGroupBox *makeData();
    QGroupBox *makeSystem();

    QComboBox *m_addresses;
    QPushButton *m_change = nullptr;
    QLabel *m_temperature = nullptr;
    QLabel *m_tilt = nullptr;
    QLabel *m_address = nullptr;
    QLabel *m_firmware = nullptr;
    QComboBox *m_newAddress = nullptr;
    QPushButton *m_write = nullptr;
    QPushButton *m_reset = nullptr;
    QProgressBar *m_restart = nullptr;
    bool m_isShown = false;
};

} // namespace gorizont
