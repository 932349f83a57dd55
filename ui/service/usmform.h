#pragma once

#include <QWidget>

class QComboBox;
class QGroupBox;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace gorizont {

class UsmDevicePanel;
class UsmRecorderPanel;
class UsmRecordsPanel;
class UsmSettingsPanel;

/// <Параметры обмена> of an УСМ-ИСН, with the search by serial number, and the tabs below. GUI thread.
class UsmForm : public QWidget
{
    Q_OBJECT

public:
    /// Puts the list of \a addresses in its place.
    explicit UsmForm(QComboBox *addresses, QWidget *parent = nullptr);

    UsmDevicePanel *device() const { return m_device; }
    UsmSettingsPanel *settings() const { return m_settings; }
    UsmRecorderPanel *recorder() const { return m_recorder; }
    UsmRecordsPanel *records() const { return m_records; }

    QList<quint32> serials() const; ///< those typed; empty: something else is
    void setMayFind(bool mayFind);

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void findWanted();

private:
    QGroupBox *makeExchange();

    QComboBox *m_addresses;
    QLineEdit *m_serials = nullptr;
    QPushButton *m_find = nullptr;
    QTabWidget *m_tabs;
    UsmDevicePanel *m_device;
    UsmSettingsPanel *m_settings;
    UsmRecorderPanel *m_recorder;
    UsmRecordsPanel *m_records;
    bool m_mayFind = false;
};

} // namespace gorizont
