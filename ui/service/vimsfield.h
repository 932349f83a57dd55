#pragma once

#include "core/devices/lvims/lvimssettings.h"

#include <QObject>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;
class QWidget;

namespace gorizont {

/// One setting of an L-VIMS in the form: its editor, what the module has, and what the user made of it. GUI thread.
class VimsField : public QObject
{
    Q_OBJECT

public:
    /// The editor has the name of the setting.
    VimsField(const lvims::Setting &setting, QWidget *parent);

    QWidget *editor() const { return m_editor; }
    const lvims::Setting &setting() const { return m_setting; }

    /// The value of \a image, as if it had been typed so.
    void show(const QList<quint16> &image);
    /// What was typed goes into \a image. Empty: done, or nothing was; else what the setting takes, a sentence.
    QString put(QList<quint16> &image) const;
    /// Makes visible that the value here is not \a inUse.
    void compare(const QString &inUse);

Q_SIGNALS:
    void edited();

private:
    void makeEditor(QWidget *parent);
    void makeMask(QWidget *parent);
    void makeTypes(QWidget *parent);
    void setText(const QString &text);
    QString text() const;

    const lvims::Setting m_setting;
    QWidget *m_editor = nullptr;
    QLineEdit *m_line = nullptr; ///< one of these is the editor, or in it
    QSpinBox *m_number = nullptr;
    QComboBox *m_types = nullptr;
    QCheckBox *m_switch = nullptr;
    QList<QCheckBox *> m_channels;
    QString m_shown; ///< text() as it was shown
};

} // namespace gorizont
