#pragma once

#include "core/devices/usmisn/usmisnvalues.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QGroupBox;
class QProgressBar;
class QPushButton;

namespace gorizont {

/// The address and the port settings of an УСМ-ИСН or of all on the line (manual 002, 3.8 – 3.10), and the silence that
/// restarts those that hang (section 4). GUI thread.
class UsmSettingsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit UsmSettingsPanel(QWidget *parent = nullptr);

    /// The addresses to choose from, nothing chosen.
    void offer(const LineConfig &line, const QList<int> &free);
    /// \a isReady: the line is free; \a isShown: a device is shown, too; \a isComplete: so was the scan.
    void setControls(bool isReady, bool isShown, bool isComplete);
    /// Per cent of the silence; empty: there is none.
    void showSilence(std::optional<int> percent);

    int newAddress() const; ///< 0: none is chosen
    PortSettings portSettings() const;
    bool isForAll() const; ///< a broadcast is wanted

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void chosen(); ///< something else may be pressed now
    void addressWanted();
    void portWanted();
    void factoryPortWanted();
    void silenceWanted();

private:
    QGroupBox *makeAddress();
    QGroupBox *makePort();
    QGroupBox *makeSilence();

    QCheckBox *m_forAll;
    QComboBox *m_newAddress = nullptr;
    QPushButton *m_writeAddress = nullptr;
    QComboBox *m_baud = nullptr;
    QComboBox *m_parity = nullptr;
    QComboBox *m_stopBits = nullptr;
    QPushButton *m_writePort = nullptr;
    QPushButton *m_factoryPort = nullptr;
    QProgressBar *m_silence = nullptr;
    QPushButton *m_keepSilent = nullptr;
};

} // namespace gorizont
