#include "ui/pages/journalpage.h"

#include "ui/models/journalmodel.h"
#include "ui/pages/tableview.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

JournalPage::JournalPage(const Journal &journal, QWidget *parent)
    : QWidget(parent)
    , m_filter(new JournalFilter(this))
{
    m_filter->setSourceModel(new JournalModel(journal, this));
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(8, 4, 8, 4);
    bar->setSpacing(16);
    addKind(bar, JournalKind::Error, tr("Errors"), QStringLiteral("showErrors"));
    addKind(bar, JournalKind::On, tr("Switched on"), QStringLiteral("showOn"));
    addKind(bar, JournalKind::Off, tr("Switched off"), QStringLiteral("showOff"));
    addKind(bar, JournalKind::Info, tr("Information"), QStringLiteral("showInfo"));
    bar->addStretch();

    auto *view = new TableView(QStringLiteral("journalTable"), this);
    view->setModel(m_filter);
    view->setAlternatingRowColors(false);
    view->horizontalHeader()->hide();
    view->horizontalHeader()->setStretchLastSection(true);
    view->followEnd();

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(view);
}

void JournalPage::addKind(QHBoxLayout *bar, JournalKind kind, const QString &title, const QString &objectName)
{
    auto *box = new QCheckBox(title, this);
    box->setObjectName(objectName);
    box->setChecked(true);
    connect(box, &QCheckBox::toggled, this, [this, kind](bool isShown) { m_filter->setShown(kind, isShown); });
    bar->addWidget(box);
}

} // namespace gorizont
