#include "ui/registermapdialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QGuiApplication>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSaveFile>
#include <QScreen>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextTable>
#include <QVBoxLayout>

#include <utility>

namespace gorizont {

namespace {

/// Longer sections are shown as they are: laying out their tables would hold up the window.
constexpr qsizetype longestFormatted = 20'000; ///< characters

/// Thin lines instead of boxes.
void styleTables(QTextDocument &document)
{
    for (QTextFrame *frame : document.rootFrame()->childFrames()) {
        if (auto *table = qobject_cast<QTextTable *>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorderCollapse(true);
            format.setBorder(1);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(QGuiApplication::palette().mid());
            format.setCellPadding(3);
            format.setCellSpacing(0);
            table->setFormat(format);
        }
    }
}

} // namespace

RegisterMapDialog::RegisterMapDialog(const QString &markdown, QWidget *parent)
    : QDialog(parent)
    , m_markdown(markdown)
    , m_list(new QListWidget(this))
    , m_text(new QTextBrowser(this))
{
    setObjectName(QStringLiteral("registerMapDialog"));
    setWindowTitle(tr("Modbus register map"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_list->setObjectName(QStringLiteral("registerMapSections"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long names are cut off; the tool tip has them
    m_list->setTextElideMode(Qt::ElideRight);
    m_text->setObjectName(QStringLiteral("registerMapText"));
    m_text->setWordWrapMode(QTextOption::WordWrap); // names of fields stay whole
    auto *splitter = new QSplitter(this);
    splitter->addWidget(m_list);
    splitter->addWidget(m_text);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({340, 860});
    splitter->setStretchFactor(1, 1);
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *copy = buttons->addButton(tr("Copy all"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("registerMapCopy"));
    QPushButton *saveAs = buttons->addButton(tr("Save as…"), QDialogButtonBox::ActionRole);
    saveAs->setObjectName(QStringLiteral("registerMapSave"));
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::AcceptRole);
    close->setObjectName(QStringLiteral("registerMapClose"));
    close->setDefault(true);
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_markdown); });
    connect(saveAs, &QPushButton::clicked, this, &RegisterMapDialog::askWhereToSave);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_list, &QListWidget::currentRowChanged, this, &RegisterMapDialog::showSection);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(splitter);
    layout->addWidget(buttons);
    resize(QSize(1200, 720).boundedTo(screen()->availableSize() * 0.9));
    splitIntoSections();
    m_list->setCurrentRow(0);
    m_list->setFocus();
}

/// At the title, at every unit and at every sensor.
void RegisterMapDialog::splitIntoSections()
{
    static const QRegularExpression heading(QStringLiteral("^(#|##|####) (.*)$"), QRegularExpression::MultilineOption);
    static const QRegularExpression escape(QStringLiteral("\\\\(.)"));
    qsizetype start = 0;
    for (auto found = heading.globalMatch(m_markdown); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        if (m_list->count() > 0) {
            m_sections.append(m_markdown.sliced(start, match.capturedStart() - start));
        }
        start = match.capturedStart();
        const QString indent = match.capturedLength(1) > 2 ? QStringLiteral("    ") : QString();
        const QString title = match.captured(2).replace(escape, QStringLiteral("\\1"));
        auto *item = new QListWidgetItem(indent + title, m_list);
        item->setToolTip(title.toHtmlEscaped());
    }
    m_sections.append(m_markdown.sliced(start));
}

/// Into a document that no view lays out yet: filling one that is seen takes a hundred times as long.
void RegisterMapDialog::showSection(int index)
{
    const QString section = m_sections.value(index);
    const bool isFormatted = section.size() <= longestFormatted;
    auto *document = new QTextDocument(this);
    document->setDefaultFont(m_text->font());
    if (isFormatted) {
        document->setMarkdown(
            section,
            QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) | QTextDocument::MarkdownNoHTML);
        styleTables(*document);
    } else {
        document->setPlainText(section);
    }
    m_text->setLineWrapMode(isFormatted ? QTextEdit::WidgetWidth : QTextEdit::NoWrap);
    m_text->setDocument(document);
    delete std::exchange(m_document, document);
}

void RegisterMapDialog::askWhereToSave()
{
    auto *dialog = new QFileDialog(this, tr("Save the register map"), QDir::homePath(), tr("Markdown (*.md)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("md"));
    dialog->selectFile(QStringLiteral("GorizontServer-Modbus.md"));
    connect(dialog, &QFileDialog::fileSelected, this, &RegisterMapDialog::save);
    dialog->open();
}

void RegisterMapDialog::save(const QString &path)
{
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(m_markdown.toUtf8()) >= 0 && file.commit()) {
        return;
    }
    auto *box = new QMessageBox(QMessageBox::Warning, windowTitle(), tr("The file cannot be saved."), {}, this);
    box->setObjectName(QStringLiteral("registerMapProblem"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(QStringLiteral("%1\n%2").arg(QDir::toNativeSeparators(path), file.errorString()));
    box->addButton(tr("Close"), QMessageBox::AcceptRole);
    box->open();
}

} // namespace gorizont
