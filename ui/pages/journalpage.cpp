#include "ui/pages/journalpage.h"

#include "ui/models/journalmodel.h"
#include "ui/pages/searchfield.h"
#include "ui/pages/tableview.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

JournalPage::JournalPage(const Journal &journal, QWidget *parent)
    : QWidget(parent)
    , m_filter(new JournalFilter(this))
    , m_view(new TableView(QStringLiteral("journalTable"), this))
{
    m_filter->setSourceModel(new JournalModel(journal, this));
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(8, 4, 8, 4);
    bar->setSpacing(16);
    addKind(bar, JournalKind::Error, tr("Errors"), QStringLiteral("showErrors"));
    addKind(bar, JournalKind::On, tr("Switched on"), QStringLiteral("showOn"));
    addKind(bar, JournalKind::Off, tr("Switched off"), QStringLiteral("showOff"));
    addKind(bar, JournalKind::Info, tr("Information"), QStringLiteral("showInfo"));
    addSearch(bar);

    m_view->setModel(m_filter);
    m_view->setAlternatingRowColors(false);
    m_view->horizontalHeader()->hide();
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->followEnd();

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_view);
    onFilterChanged();
}

void JournalPage::addKind(QHBoxLayout *bar, JournalKind kind, const QString &title, const QString &objectName)
{
    auto *box = new QCheckBox(title, this);
    box->setIcon(journalIcon(kind));
    box->setObjectName(objectName);
    box->setChecked(true);
    connect(box, &QCheckBox::toggled, this, [this, kind](bool isShown) {
        m_filter->setShown(kind, isShown);
        onFilterChanged();
    });
    bar->addWidget(box);
}

void JournalPage::addSearch(QHBoxLayout *bar)
{
    auto *search = new SearchField(QStringLiteral("journalSearch"), tr("Text of the event"), this);
    search->setMinimumWidth(fontMetrics().averageCharWidth() * 28);
    connect(search, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_filter->setText(text);
        onFilterChanged();
    });
    connect(search, &SearchField::left, m_view, qOverload<>(&QWidget::setFocus));
    bar->addStretch(1);
    bar->addWidget(search, 2);
}

void JournalPage::onFilterChanged()
{
    m_view->setEmptyText(m_filter->isFiltering() ? tr("No event passes this filter.") : tr("No events yet."));
}

} // namespace gorizont
