#pragma once

#include <QWidget>

class QComboBox;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace gorizont {

class VimsComparison;
class VimsModulePanel;
class VimsSettingsPanel;

/// Module, settings and comparison of an L-VIMS in tabs, and below them a button for each thing that is done with settings. GUI
/// thread.
class VimsForm : public QWidget
{
    Q_OBJECT

public:
    /// What may be pressed.
    struct Controls
    {
        bool isFree = false; ///< a module is there, and nothing else is done
        bool isKnown = false; ///< its settings were read
        bool isEdited = false; ///< something may be written
    };

    /// Puts the list of \a modules in its place.
    explicit VimsForm(QComboBox *modules, QWidget *parent = nullptr);

    VimsModulePanel *module() const { return m_module; }
    VimsSettingsPanel *settings() const { return m_settings; }

    /// \a inUse (CUR) and \a prepared (MUT) beside what is wanted; empty: they are not known.
    void compare(const QList<quint16> &inUse, const QList<quint16> &prepared);
    void setControls(const Controls &controls);
    void showProgress(qsizetype done, qsizetype total); ///< 0 of 0: nothing goes on

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void readWanted();
    void writeWanted();
    void applyWanted();
    void flashWanted();
    void reloadWanted();
    void openWanted();
    void saveWanted();

private:
    QPushButton *addButton(const QString &text, const char *name, const QString &toolTip, void (VimsForm::*wanted)());
    QWidget *makeButtons();

    QComboBox *m_modules;
    QTabWidget *m_tabs;
    VimsModulePanel *m_module;
    VimsSettingsPanel *m_settings;
    VimsComparison *m_comparison;
    QProgressBar *m_progress;
    QList<QPushButton *> m_buttons; ///< in the order of the tab key
    QPushButton *m_read = nullptr;
    QPushButton *m_write = nullptr;
};

} // namespace gorizont
