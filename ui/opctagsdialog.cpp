#include "ui/opctagsdialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QScreen>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTableView>
#include <QVBoxLayout>

namespace gorizont {

OpcTagsDialog::OpcTagsDialog(const QString &list, const QString &message, QWidget *parent)
    : QDialog(parent)
    , m_list(list)
    , m_search(new QLineEdit(this))
    , m_found(new QSortFilterProxyModel(this))
{
    setObjectName(QStringLiteral("opcTagsDialog"));
    setWindowTitle(tr("OPC DA tags"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto *layout = new QVBoxLayout(this);
    if (!message.isEmpty()) {
        auto *told = new QLabel(message, this);
        told->setObjectName(QStringLiteral("opcTagsMessage"));
        told->setTextFormat(Qt::PlainText);
        told->setWordWrap(true);
        told->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        layout->addWidget(told);
    }
    m_search->setObjectName(QStringLiteral("opcTagsSearch"));
    m_search->setPlaceholderText(tr("Find a tag"));
    m_search->setClearButtonEnabled(true);
    connect(m_search, &QLineEdit::textChanged, m_found, &QSortFilterProxyModel::setFilterFixedString);
    layout->addWidget(m_search);
    layout->addWidget(makeTable(), 1);
    layout->addWidget(makeButtons());
    resize(QSize(1100, 680).boundedTo(screen()->availableSize() * 0.9));
}

QWidget *OpcTagsDialog::makeTable()
{
    auto *model = new QStandardItemModel(0, 3, this);
    model->setHorizontalHeaderLabels({tr("Tag"), tr("Type"), tr("Description")});
    for (const QString &line : m_list.split(u'\n', Qt::SkipEmptyParts)) {
        QList<QStandardItem *> row;
        for (const QString &field : line.split(u'\t')) {
            row.append(new QStandardItem(field));
            row.last()->setEditable(false);
        }
        model->appendRow(row);
    }
    m_found->setSourceModel(model);
    m_found->setFilterKeyColumn(-1);
    m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
    auto *table = new QTableView(this);
    table->setObjectName(QStringLiteral("opcTagsTable"));
    table->setModel(m_found);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setWordWrap(false);
    const QFontMetrics metrics = table->fontMetrics();
    table->setShowGrid(false);
    table->setAlternatingRowColors(true);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(metrics.height() + 4);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setColumnWidth(
        0, metrics.horizontalAdvance(QStringLiteral("[COM16].Sensor_001[USMISN][Addr:002].STATE.ReadyAngl_")));
    table->setColumnWidth(1, metrics.horizontalAdvance(QStringLiteral("double___")));
    return table;
}

QWidget *OpcTagsDialog::makeButtons()
{
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *copy = buttons->addButton(tr("Copy all"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("opcTagsCopy"));
    QPushButton *saveAs = buttons->addButton(tr("Save as…"), QDialogButtonBox::ActionRole);
    saveAs->setObjectName(QStringLiteral("opcTagsSave"));
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::AcceptRole);
    close->setObjectName(QStringLiteral("opcTagsClose"));
    close->setDefault(true);
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_list); });
    connect(saveAs, &QPushButton::clicked, this, &OpcTagsDialog::askWhereToSave);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    return buttons;
}

void OpcTagsDialog::askWhereToSave()
{
    auto *dialog = new QFileDialog(this, tr("Save the tags"), QDir::homePath(), tr("Text (*.txt)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("txt"));
    dialog->selectFile(QStringLiteral("GorizontServer-OPC.txt"));
    connect(dialog, &QFileDialog::fileSelected, this, &OpcTagsDialog::save);
    dialog->open();
}

void OpcTagsDialog::save(const QString &path)
{
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(m_list.toUtf8()) >= 0 && file.commit()) {
        return;
    }
    auto *box = new QMessageBox(QMessageBox::Warning, windowTitle(), tr("The file cannot be saved."), {}, this);
    box->setObjectName(QStringLiteral("opcTagsProblem"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(QStringLiteral("%1\n%2").arg(QDir::toNativeSeparators(path), file.errorString()));
    box->addButton(tr("Close"), QMessageBox::AcceptRole);
    box->open();
}

} // namespace gorizont
