#pragma once

#include <QWidget>

class QComboBox;
class QTabWidget;

namespace gorizont {

class Mk14OutputsPanel;
class Mk14TransferPanel;
class Mk14ValuesPanel;

/// <Параметры обмена> of a weather station and the tabs below. GUI thread.
class Mk14Form : public QWidget
{
    Q_OBJECT

public:
    /// Puts the list of \a addresses in its place.
    explicit Mk14Form(QComboBox *addresses, QWidget *parent = nullptr);

    Mk14ValuesPanel *values() const { return m_values; }
    Mk14OutputsPanel *outputs() const { return m_outputs; }
    Mk14TransferPanel *transfer() const { return m_transfer; }

    QWidgetList tabOrder() const;

private:
    QComboBox *m_addresses;
    QTabWidget *m_tabs;
    Mk14ValuesPanel *m_values;
    Mk14OutputsPanel *m_outputs;
    Mk14TransferPanel *m_transfer;
};

} // namespace gorizont
