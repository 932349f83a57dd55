#pragma once

#include <QList>
#include <QWidget>

class QGridLayout;
class QGroupBox;
class QLabel;
class QTabWidget;

namespace gorizont {

class VimsField;

/// The settings of manual 003, section 2.4, as they are prepared in a module and as the user wants them. Those that differ
/// from what is in use stand out. GUI thread.
class VimsSettingsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit VimsSettingsPanel(QWidget *parent = nullptr);

    /// What the module has: \a inUse (CUR) and \a prepared (MUT); empty: it is not known.
    void showModule(const QList<quint16> &inUse, const QList<quint16> &prepared);
    /// All of \a image is wanted, that of a file; what was typed is gone.
    void want(const QList<quint16> &image);

    /// With what was typed; complaint() is empty then.
    QList<quint16> wanted() const { return m_wanted; }
    /// The first thing that was typed and is not possible, a sentence; empty: everything is.
    QString complaint() const { return m_complaint; }
    bool isEdited() const; ///< something differs from what is prepared, or is not possible

    void setEditable(bool isEditable);
    QWidgetList tabOrder() const;

Q_SIGNALS:
    void edited();

private:
    VimsField *field(const QString &name, QWidget *parent);
    QGroupBox *makeModule();
    QTabWidget *makeChannels();
    QWidget *makeChannel(int channel, QWidget *parent);
    void addMeasurement(QGridLayout &grid, int row, const QString &name, QWidget *parent);
    void take();

    QList<VimsField *> m_fields;
    QTabWidget *m_channels = nullptr;
    QLabel *m_told; ///< the complaint
    QList<quint16> m_inUse;
    QList<quint16> m_prepared;
    QList<quint16> m_base; ///< what the fields were filled with
    QList<quint16> m_wanted;
    QString m_complaint;
};

} // namespace gorizont
