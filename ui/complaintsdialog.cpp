#include "ui/complaintsdialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace gorizont {

ComplaintsDialog::ComplaintsDialog(const QList<Complaint> &complaints, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("complaintsDialog"));
    setWindowTitle(tr("Configuration file"));
    setAttribute(Qt::WA_DeleteOnClose);
    QStringList lines;
    for (const Complaint &complaint : complaints) {
        lines += complaint.text();
    }
    auto *heading = new QLabel(
        tr("%n entry(ies) of the configuration file cannot be used as they are. The program works without them.",
           nullptr, static_cast<int>(complaints.size())),
        this);
    heading->setWordWrap(true);
    auto *text = new QPlainTextEdit(lines.join(QStringLiteral("\n\n")), this);
    text->setObjectName(QStringLiteral("complaintsText"));
    text->setReadOnly(true);
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("complaintsCopy"));
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::AcceptRole);
    close->setObjectName(QStringLiteral("complaintsClose"));
    close->setDefault(true);
    connect(copy, &QPushButton::clicked, this, [lines] { QGuiApplication::clipboard()->setText(lines.join(u'\n')); });
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(heading);
    layout->addWidget(text);
    layout->addWidget(buttons);
    resize(720, 420);
}

} // namespace gorizont
