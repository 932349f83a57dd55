#include "ui/pages/tableview.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QProxyStyle>
#include <QScrollBar>

#include <algorithm>

namespace gorizont {

namespace {

constexpr int sideMargin = 6; ///< between a text and the edge of its cell or heading, pixels

/// The style of the desktop with room at both sides of a text. A style sheet would do, at several times the cost.
class RoomyStyle : public QProxyStyle
{
public:
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override
    {
        switch (metric) {
        case PM_HeaderMargin: return sideMargin + 1;
        case PM_FocusFrameHMargin: return sideMargin;
        default: return QProxyStyle::pixelMetric(metric, option, widget);
        }
    }
};

} // namespace

TableView::TableView(const QString &objectName, QWidget *parent)
    : QTableView(parent)
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

    auto *copy = new QAction(tr("&Copy"), this);
    copy->setObjectName(QStringLiteral("copyAction"));
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, this, &TableView::copySelection);
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
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

void TableView::setColumnSample(int column, const QString &widest)
{
    setColumnWidth(column, sampleWidth(column, widest));
}

void TableView::setElasticColumn(int column, const QString &least)
{
    m_elasticColumn = column;
    m_elasticWidth = sampleWidth(column, least);
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this](int resized) {
        if (resized != m_elasticColumn) {
            stretchElasticColumn();
        }
    });
    stretchElasticColumn();
}

void TableView::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    if (m_elasticColumn >= 0) {
        stretchElasticColumn();
    }
}

void TableView::stretchElasticColumn()
{
    const int others = horizontalHeader()->length() - columnWidth(m_elasticColumn);
    setColumnWidth(m_elasticColumn, std::max(m_elasticWidth, viewport()->width() - others));
}

int TableView::sampleWidth(int column, const QString &widest) const
{
    constexpr int margins = 2 * (sideMargin + 1);
    const int sortMark = style()->pixelMetric(QStyle::PM_HeaderMarkSize) + margins;
    const QString heading = model()->headerData(column, Qt::Horizontal).toString();
    const QFont cellFont = model()->index(0, column).data(Qt::FontRole).value<QFont>();
    const int headingWidth = fontMetrics().horizontalAdvance(heading) + (isSortingEnabled() ? sortMark : 0);
    const int cellWidth =
        std::max(fontMetrics().horizontalAdvance(widest), QFontMetrics(cellFont).horizontalAdvance(widest));
    const bool hasIcon = !model()->index(0, column).data(Qt::DecorationRole).isNull();
    const int iconWidth = hasIcon ? style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this) + margins : 0;
    return std::max(headingWidth, cellWidth + iconWidth) + margins;
}

bool TableView::isAtEnd() const
{
    return verticalScrollBar()->value() >= verticalScrollBar()->maximum();
}

void TableView::followEnd()
{
    connect(model(), &QAbstractItemModel::rowsAboutToBeInserted, this, [this] { m_wasAtEnd = isAtEnd(); });
    connect(model(), &QAbstractItemModel::rowsInserted, this, [this] {
        if (m_wasAtEnd) {
            scrollToBottom();
        }
    });
    scrollToBottom();
}

QString TableView::selectionAsText() const
{
    QModelIndexList rows = selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end(), [](const QModelIndex &a, const QModelIndex &b) { return a.row() < b.row(); });
    QStringList lines;
    for (const QModelIndex &row : std::as_const(rows)) {
        QStringList fields;
        for (int column = 0; column < model()->columnCount(); ++column) {
            fields += row.siblingAtColumn(column).data().toString();
        }
        lines += fields.join(u'\t');
    }
    return lines.join(u'\n');
}

void TableView::copySelection()
{
    const QString text = selectionAsText();
    if (!text.isEmpty()) {
        QGuiApplication::clipboard()->setText(text);
    }
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
