#pragma once

#include "ui/weather/precipitation.h"

#include <QWidget>

class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gorizont {

/// The clock of a station, and a settings file for it. GUI thread.
class Mk14TransferPanel : public QWidget
{
    Q_OBJECT

public:
    /// As a station takes it at most (manual 004, section 3.6: "small files"; a limit of ours).
    static constexpr qsizetype longestFile = 64 * 1024; ///< bytes
    static constexpr qsizetype longestName = 255; ///< bytes

    explicit Mk14TransferPanel(QWidget *parent = nullptr);

    /// What would be sent at \a now.
    void showClock(const QDateTime &now, precipitation::StationClock clock);
    /// Takes the file \a path. What is wrong with it, a sentence; empty: nothing.
    QString takeFile(const QString &path);
    QByteArray fileName() const; ///< as the station gets it; empty: what is typed is no name
    QByteArray file() const { return m_file; }
    void setControls(bool isShown);

    QWidgetList tabOrder() const;

    /// The name of a file in Latin letters; those that only look like them become them (АСК.PAR → ACK.PAR).
    static QString latin(const QString &name);

Q_SIGNALS:
    void timeWanted();
    void fileWanted(); ///< to be chosen
    void sendWanted();
    void edited();

private:
    QGroupBox *makeClock();
    QGroupBox *makeFile();
    void showFile();

    QLabel *m_rule = nullptr;
    QLabel *m_time = nullptr;
    QPushButton *m_setTime = nullptr;
    QPushButton *m_choose = nullptr;
    QLabel *m_chosen = nullptr;
    QLineEdit *m_name = nullptr;
    QPushButton *m_send = nullptr;
    QString m_path;
    QByteArray m_file;
};

} // namespace gorizont
