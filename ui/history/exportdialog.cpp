#include "ui/history/exportdialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace gorizont {

namespace {

constexpr quint64 rowsOfExcel = 1'048'575; ///< below the headings

} // namespace

ExportDialog::ExportDialog(const ArchiveSource &source, const ExportForm::Start &start, QWidget *parent)
    : QDialog(parent)
    , m_export(source)
    , m_form(new ExportForm(start, this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    m_progress->setObjectName(QStringLiteral("exportProgress"));
    m_state->setObjectName(QStringLiteral("exportState"));
    m_state->setWordWrap(true);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *buttons = new QDialogButtonBox(this);
    m_start = buttons->addButton(tr("&Export"), QDialogButtonBox::ActionRole);
    m_start->setObjectName(QStringLiteral("exportStart"));
    m_start->setDefault(true);
    m_cancel = buttons->addButton(tr("&Cancel"), QDialogButtonBox::ActionRole);
    m_cancel->setObjectName(QStringLiteral("exportCancel"));
    m_close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    m_close->setObjectName(QStringLiteral("exportClose"));
    connect(m_start, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(m_cancel, &QPushButton::clicked, &m_export, &Export::cancel);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_export, &Export::progressed, this, &ExportDialog::onProgress);
    connect(&m_export, &Export::finished, this, &ExportDialog::onFinished);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_form, 1);
    layout->addWidget(m_progress);
    layout->addWidget(m_state);
    layout->addWidget(buttons);
    setBusy(false);
    resize(sizeHint().expandedTo({fontMetrics().averageCharWidth() * 100, 0})); // names of quantities are long
}

void ExportDialog::setBusy(bool isBusy)
{
    m_form->setEnabled(!isBusy);
    m_progress->setVisible(isBusy);
    m_start->setEnabled(!isBusy);
    m_cancel->setEnabled(isBusy);
}

/// Returns at once. A file that exists is replaced only by whoever says so.
void ExportDialog::startExport()
{
    const ExportRequest request = m_form->request();
    if (request.path.isEmpty() || QFileInfo(request.path).isDir()) {
        m_state->setText(tr("Name a file to write to."));
        return;
    }
    if (!QFileInfo::exists(request.path)) {
        return beginExport(request);
    }
    auto *question = new QMessageBox(
        QMessageBox::Question, windowTitle(), tr("%1 exists. Replace it?").arg(QDir::toNativeSeparators(request.path)),
        {}, this);
    question->setObjectName(QStringLiteral("replaceQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton *yes = question->addButton(tr("&Replace"), QMessageBox::YesRole);
    yes->setObjectName(QStringLiteral("replaceYes"));
    QPushButton *no = question->addButton(tr("&Cancel"), QMessageBox::NoRole);
    no->setObjectName(QStringLiteral("replaceNo"));
    question->setDefaultButton(no);
    question->setEscapeButton(no);
    connect(yes, &QPushButton::clicked, this, [this, request] { beginExport(request); });
    question->open();
}

void ExportDialog::beginExport(const ExportRequest &request)
{
    m_format = request.format;
    m_progress->setValue(0);
    m_state->setText(tr("Reading the archive…"));
    setBusy(true);
    m_export.start(request);
}

void ExportDialog::onProgress(int percent, quint64 rows)
{
    m_progress->setValue(percent);
    m_state->setText(tr("Rows so far: %1").arg(QLocale().toString(rows)));
}

void ExportDialog::onFinished(const ExportResult &result)
{
    setBusy(false);
    if (result.isCancelled) {
        return m_state->setText(tr("Cancelled; nothing was written."));
    }
    if (!result.failure.isEmpty()) {
        return m_state->setText(result.failure);
    }
    QStringList files;
    for (const QString &file : result.files) {
        files << QDir::toNativeSeparators(file);
    }
    QString text = tr("Done, rows: %1. Written: %2").arg(QLocale().toString(result.rows), files.join(u", "));
    if (m_format == ExportFormat::CsvRussian && result.rows > rowsOfExcel) {
        text += u'\n' + tr("Excel shows the first 1,048,575 rows only: export a shorter range, or minutes.");
    }
    m_state->setText(text);
}

/// The export ends with its dialog.
void ExportDialog::reject()
{
    m_export.cancel();
    QDialog::reject();
}

} // namespace gorizont
