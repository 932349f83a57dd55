#pragma once

#include "core/devices/ind3/ind3service.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gorizont {

/// <Параметры обмена>, <Об устройстве> and <Параметры измерения> of an ИН-Д3 (manual 000, section 8.7). Knows what the
/// sensor has and what the user wants instead. GUI thread.
class Ind3Form : public QWidget
{
    Q_OBJECT

public:
    static constexpr double largestOffset = 16383.99; ///< arc-seconds; beyond it the protocol has only arc-minutes

    /// Puts the list of \a addresses, the button \a change and the list of \a protocols in their places.
    Ind3Form(QComboBox *addresses, QPushButton *change, QComboBox *protocols, QWidget *parent = nullptr);

    void showSettings(const ind3::Settings &settings);
    void clear();
    void showTilt(const std::optional<Tilt> &tilt); ///< arc-seconds
    void setEditable(bool isEditable);

    const std::optional<ind3::Settings> &settings() const { return m_settings; } ///< what the sensor has
    /// What differs from the sensor; of a field with a problem nothing.
    ind3::Changes changes() const;
    bool isEdited() const; ///< something differs, valid or not
    QString problem() const; ///< what is wrong with the first field that cannot be written; empty: nothing

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void edited();

private:
    QGroupBox *makeExchange(QComboBox *addresses, QPushButton *change, QComboBox *protocols);
    QGroupBox *makeAbout();
    QGroupBox *makeMeasuring();
    QLineEdit *makeOffset(const QString &objectName);
    void onEdited();
    bool isOffsetEdited() const;
    std::optional<Tilt> typedOffset() const; ///< empty: not a pair of numbers in the range

    std::optional<ind3::Settings> m_settings;
    bool m_isEditable = false;
    QWidgetList m_exchangeOrder;

    QLineEdit *m_name = nullptr;
    QLabel *m_baud = nullptr;
    QLabel *m_version = nullptr;
    QLabel *m_revision = nullptr;
    QLabel *m_serialNumber = nullptr;
    QLineEdit *m_offsetX = nullptr;
    QLineEdit *m_offsetY = nullptr;
    QComboBox *m_ticks = nullptr;
    QComboBox *m_period = nullptr;
    QLabel *m_tilt = nullptr;
    QLabel *m_problem = nullptr;
};

} // namespace gorizont
