#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/vibration/vibrationcapture.h"

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace gorizont {

class VibrationPlots;

/// The page <Вибрация>: captures the waveform of a channel of an L-VIMS and the spectra of the module while polling goes on, once or every few
/// seconds, and shows them. Leaving it ends a capture. GUI thread.
class VibrationPage : public QWidget
{
    Q_OBJECT

public:
    /// The worker of section [Port{port}]; null when that port is off.
    using WorkerOf = std::function<LineWorker *(int port)>;

    /// Registry and workers outlive the page.
    VibrationPage(SensorRegistry &registry, WorkerOf worker, const Timing &timing, QWidget *parent = nullptr);
    ~VibrationPage() override;

    /// Writes what was captured last. Empty: done; else why not, a sentence.
    enum class Export : quint8 { WaveformCsv, WaveformWav, Spectrum5000Csv, Spectrum200Csv };
    QString exportTo(const QString &path, Export form) const;

protected:
    void hideEvent(QHideEvent *event) override;

private:
    void buildCapturing(QHBoxLayout &row);
    void buildViewing(QHBoxLayout &row);
    void buildSaving(QMenu &menu);
    void build();

    const SensorConfig *module() const; ///< that is chosen; nullptr: the site has none
    LineState lineState() const; ///< of its port
    int channel() const;
    void choose();
    void capture();
    void stop(const QString &why);
    void take(const CapturedSignal &signal);
    void takeFailure(const CaptureFailure &failure);
    void endRound();
    void refresh();
    QString objection() const; ///< why nothing can be captured now, a sentence
    QString channelNote() const;
    void say(const QString &text);
    void changeView();
    void askExport(Export form);

    SensorRegistry &m_registry;
    const WorkerOf m_worker;
    const Timing m_timing;
    VibrationCapture *m_capture;
    VibrationPlots *m_plots;
    QStackedWidget *m_content;
    QLabel *m_hint;
    QComboBox *m_modules;
    QComboBox *m_channels;
    QPushButton *m_start;
    QPushButton *m_stop;
    QCheckBox *m_repeats;
    QSpinBox *m_period; ///< s, from the beginning of one round to that of the next
    QComboBox *m_units;
    QComboBox *m_scales;
    QCheckBox *m_cursors;
    QPushButton *m_save;
    QProgressBar *m_progress;
    QLabel *m_state;
    QList<QAction *> m_exports; ///< in the order of Export
    QTimer m_next; ///< the next round
    SteadyTime m_begun{}; ///< the last round
    QStringList m_failures; ///< of the round
    QString m_captured; ///< what it brought; empty: no waveform
    QString m_said;
};

} // namespace gorizont
