#pragma once

#include "core/export/export.h"
#include "ui/history/exportform.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace gorizont {

/// Asks what to export, and exports it while the window goes on; closing it ends the export. GUI thread.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    ExportDialog(const ArchiveSource &source, const ExportForm::Start &start, QWidget *parent = nullptr);

    void reject() override;

private:
    void startExport();
    void beginExport(const ExportRequest &request);
    void onProgress(int percent, quint64 rows);
    void onFinished(const ExportResult &result);
    void setBusy(bool isBusy);

    Export m_export;
    ExportForm *m_form;
    QProgressBar *m_progress;
    QLabel *m_state; ///< how it goes, and what came of it
    QPushButton *m_start;
    QPushButton *m_cancel;
    QPushButton *m_close;
    ExportFormat m_format = ExportFormat::CsvRussian; ///< of what runs
};

} // namespace gorizont
