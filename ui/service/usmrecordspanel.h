#pragma once

#include "core/devices/usmisn/usmisnrecords.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace gorizont {

/// The records of an УСМ-ИСН (manual 002, 3.12): which are to be downloaded, and what is there so far. GUI thread.
class UsmRecordsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit UsmRecordsPanel(QWidget *parent = nullptr);

    void showBook(const usmisn::RecordBook &book);
    /// Where the records go, a sentence.
    void showArchive(const QString &text);
    /// \a isRunning: a download can be stopped; \a hasRecords: there is something to save.
    void setControls(bool mayDownload, bool isRunning, bool hasRecords);

    QWidgetList tabOrder() const;

Q_SIGNALS:
    void downloadWanted(gorizont::usmisn::RecordMask mask);
    void stopWanted();
    void saveWanted();

private:
    QWidget *makeCounts();

    QLabel *m_count = nullptr;
    QLabel *m_span = nullptr;
    QLabel *m_missing = nullptr;
    QLabel *m_archive = nullptr;
    QProgressBar *m_progress;
    QPushButton *m_new;
    QPushButton *m_all;
    QPushButton *m_stop;
    QPushButton *m_save;
};

} // namespace gorizont
