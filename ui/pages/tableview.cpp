#include "ui/pages/tableview.h"

#include "ui/models/colours.h"
#include "ui/pages/endfollower.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tabletext.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QProxyStyle>
#include <QTimer>

#include <algorithm>
#include <numeric>

namespace gorizont {

namespace {

/// The style of the desktop with room at both sides of a text. A style sheet would do, at several times the cost.
class RoomyStyle : public QProxyStyle
{
public:
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override
    {
        switch (metric) {
        case PM_HeaderMargin: return TableColumns::sideMargin + 1;
        case PM_FocusFrameHMargin: return TableColumns::sideMargin;
        default: return QProxyStyle::pixelMetric(metric, option, widget);
        }
    }
};

void toClipboard(const QString &text)
{
    if (!text.isEmpty()) {
        QGuiApplication::clipboard()->setText(text);
    }
}

} // namespace

TableView::TableView(const QString &objectName, QWidget *parent)
    : QTableView(parent)
    , m_columns(new TableColumns(this))
{
    setObjectName(objectName);
    auto *roomy = new RoomyStyle;
    roomy->setParent(this);
    setStyle(roomy);
    horizontalHeader()->setStyle(roomy);
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollMode(ScrollPerPixel);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().averageCharWidth() * 4);
    connect(this, &QTableView::doubleClicked, this, &TableView::rowChosen);
    addActions();
}

QAction *TableView::addCopyAction(const QString &title, const char *objectName, void (TableView::*copy)())
{
    auto *action = new QAction(title, this);
    action->setObjectName(QLatin1String(objectName));
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, copy);
    addAction(action);
    return action;
}

void TableView::addActions()
{
    m_copyCell = addCopyAction(tr("Copy the &cell"), "copyCellAction", &TableView::copyCell);
    m_copyRows = addCopyAction(tr("Copy the &rows"), "copyRowsAction", &TableView::copySelection);
    m_copyRows->setShortcut(QKeySequence::Copy);
    m_copyTable = addCopyAction(tr("Copy the &table"), "copyTableAction", &TableView::copyTable);

    auto *restore = new QAction(tr("Restore the columns"), this);
    restore->setObjectName(QStringLiteral("restoreColumnsAction"));
    connect(restore, &QAction::triggered, m_columns, &TableColumns::restore);
    horizontalHeader()->addAction(restore);
    horizontalHeader()->setContextMenuPolicy(Qt::ActionsContextMenu);
}

TableView::Rows TableView::visibleRows() const
{
    if (!isVisible() || !model() || model()->rowCount() == 0) {
        return {};
    }
    const int first = rowAt(0);
    const int last = rowAt(viewport()->height() - 1);
    return {std::max(0, first), last < 0 ? model()->rowCount() - 1 : last};
}

void TableView::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    m_columns->stretch();
}

void TableView::followEnd()
{
    new EndFollower(this);
}

/// The current row may be among them; Qt would scroll to the next one, away from what somebody reads.
void TableView::rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last)
{
    setAutoScroll(false);
    QTableView::rowsAboutToBeRemoved(parent, first, last);
    QTimer::singleShot(0, this, [this] { setAutoScroll(true); });
}

void TableView::setEmptyText(const QString &text)
{
    m_emptyText = text;
    setAccessibleDescription(text);
    viewport()->update();
}

void TableView::paintEvent(QPaintEvent *event)
{
    QTableView::paintEvent(event);
    if (m_emptyText.isEmpty() || !model() || model()->rowCount() > 0) {
        return;
    }
    QPainter painter(viewport());
    painter.setPen(colours::mutedText(palette()));
    constexpr int margin = 4 * TableColumns::sideMargin;
    painter.drawText(
        viewport()->rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
}

QString TableView::selectionAsText() const
{
    QList<int> rows;
    for (const QModelIndex &index : selectionModel()->selectedRows()) {
        rows += index.row();
    }
    std::sort(rows.begin(), rows.end());
    return tabletext::rows(*horizontalHeader(), rows);
}

QString TableView::tableAsText() const
{
    QList<int> rows(model()->rowCount());
    std::iota(rows.begin(), rows.end(), 0);
    const QString text = tabletext::rows(*horizontalHeader(), rows);
    return horizontalHeader()->isHidden() ? text : tabletext::headings(*horizontalHeader()) + u'\n' + text;
}

void TableView::copyCell()
{
    toClipboard(tabletext::cell(currentIndex().data().toString()));
}

void TableView::copySelection()
{
    toClipboard(selectionAsText());
}

void TableView::copyTable()
{
    toClipboard(tableAsText());
}

void TableView::updateActions()
{
    m_copyCell->setEnabled(currentIndex().isValid());
    m_copyRows->setEnabled(selectionModel() && selectionModel()->hasSelection());
    m_copyTable->setEnabled(model() && model()->rowCount() > 0);
}

void TableView::contextMenuEvent(QContextMenuEvent *event)
{
    updateActions();
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("tableMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(actions());
    // An action that is off now must still take its shortcut later, when there is something to copy.
    connect(menu, &QMenu::aboutToHide, this, [this] {
        for (QAction *action : {m_copyCell, m_copyRows, m_copyTable}) {
            action->setEnabled(true);
        }
    });
    menu->popup(event->globalPos());
}

void TableView::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && currentIndex().isValid()) {
        Q_EMIT rowChosen(currentIndex());
        return;
    }
    QTableView::keyPressEvent(event);
}

} // namespace gorizont
