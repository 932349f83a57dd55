#include "ui/attentiondialog.h"

#include "core/alarms/alarmtext.h"
#include "core/alarms/alarmwatch.h"
#include "core/values/statustext.h"
#include "ui/models/attentionmodel.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

namespace gorizont {

namespace {

constexpr int linesPerRow = 3; ///< what to do is a sentence, and a scaled screen is narrow

} // namespace

AttentionDialog::AttentionDialog(const SensorRegistry &registry, AlarmWatch &alarms, QWidget *parent)
    : QDialog(parent)
    , m_registry(registry)
    , m_alarms(alarms)
    , m_model(new AttentionModel(this))
    , m_sorted(new QSortFilterProxyModel(this))
    , m_view(new TableView(QStringLiteral("attentionTable"), this))
    , m_summary(new QLabel(this))
{
    setObjectName(QStringLiteral("attentionDialog"));
    setWindowTitle(tr("Messages for the dispatcher"));
    m_summary->setObjectName(QStringLiteral("attentionSummary"));
    buildTable();
    auto *bottom = new QHBoxLayout;
    bottom->setContentsMargins(8, 4, 8, 8);
    bottom->addWidget(m_summary, 1);
    m_accept = addButton(bottom, tr("&Accept"), QStringLiteral("acceptSelected"));
    m_acceptAll = addButton(bottom, tr("Accept a&ll"), QStringLiteral("acceptAll"));
    QPushButton *closeButton = addButton(bottom, tr("&Close"), QStringLiteral("attentionClose"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view, 1);
    layout->addLayout(bottom);
    resize(QSize(1060, 420).boundedTo(screen()->availableSize()));

    connect(m_accept, &QPushButton::clicked, this, &AttentionDialog::acceptSelected);
    connect(m_acceptAll, &QPushButton::clicked, this, &AttentionDialog::acceptAll);
    connect(closeButton, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_view, &TableView::rowChosen, this, [this](const QModelIndex &index) { Q_EMIT chosen(itemAt(index)); });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &AttentionDialog::updateButtons);
    connect(&alarms, &AlarmWatch::changed, this, &AttentionDialog::refresh);
    refresh();
    m_view->setFocus();
}

void AttentionDialog::buildTable()
{
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(AttentionModel::SortRole);
    m_sorted->setSortLocaleAware(true);
    m_view->setModel(m_sorted);
    m_view->columns().setDefaultSort(AttentionModel::Began, Qt::DescendingOrder);
    m_view->setWordWrap(true);
    m_view->verticalHeader()->setDefaultSectionSize(linesPerRow * fontMetrics().lineSpacing() + 8);
    SensorConfig sensor;
    sensor.model = QStringLiteral("AN-D3");
    sensor.number = 100;
    sensor.address = 100;
    LineConfig line;
    line.com = 10;
    m_view->columns().setSample(AttentionModel::Began, QStringLiteral("00:00:00 00.00.00"));
    m_view->columns().setSample(AttentionModel::Subject, sensorTitle(sensor, line));
    m_view->columns().setSample(AttentionModel::Place, QString(16, u'x'));
    m_view->columns().setSample(AttentionModel::Meaning, QString(24, u'x'));
    m_view->columns().setElastic(AttentionModel::Advice, QString(44, u'x'));

    auto *accept = new QAction(tr("&Accept"), m_view);
    accept->setObjectName(QStringLiteral("acceptAction"));
    accept->setShortcuts({QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_Space)});
    accept->setShortcutContext(Qt::WidgetShortcut);
    connect(accept, &QAction::triggered, this, &AttentionDialog::acceptSelected);
    m_view->addAction(accept);
}

/// None of them is the default: Enter in the table must never accept anything.
QPushButton *AttentionDialog::addButton(QBoxLayout *layout, const QString &title, const QString &objectName)
{
    auto *button = new QPushButton(title, this);
    button->setObjectName(objectName);
    button->setAutoDefault(false);
    layout->addWidget(button);
    return button;
}

/// The first row is ready for the keyboard.
void AttentionDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    if (!m_view->selectionModel()->hasSelection()) {
        m_view->selectRow(0);
    }
}

void AttentionDialog::refresh()
{
    const Alarms alarms = m_alarms.unacknowledged();
    m_model->setAlarms(alarms);
    QStringList parts{alarms.isEmpty() ? tr("There are no messages") : alarmtext::sensorsNeedAttention(alarms)};
    if (const int accepted = m_alarms.acknowledgedCount(); accepted > 0) {
        parts += tr("accepted, not mended yet: %1").arg(accepted);
    }
    m_summary->setText(parts.join(QStringLiteral(", ")));
    updateButtons();
}

void AttentionDialog::updateButtons()
{
    m_accept->setEnabled(m_view->selectionModel()->hasSelection());
    m_acceptAll->setEnabled(m_model->rowCount() > 0);
}

void AttentionDialog::acceptSelected()
{
    QList<quint64> ids;
    for (const QModelIndex &row : m_view->selectionModel()->selectedRows()) {
        ids.append(m_model->alarmAt(m_sorted->mapToSource(row).row()).id);
    }
    if (ids.isEmpty()) {
        return;
    }
    m_alarms.acknowledge(ids);
    m_view->setFocus(); // the button may have gone grey
    if (m_view->currentIndex().isValid()) {
        m_view->selectRow(m_view->currentIndex().row()); // the next one, so that the keyboard goes on
    }
}

/// What the list shows, not what may have come in the meantime.
void AttentionDialog::acceptAll()
{
    QList<quint64> ids;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        ids.append(m_model->alarmAt(row).id);
    }
    m_alarms.acknowledge(ids);
}

SiteItem AttentionDialog::itemAt(const QModelIndex &index) const
{
    const Alarm &alarm = m_model->alarmAt(m_sorted->mapToSource(index).row());
    return alarm.isWholePort() ? SiteItem::line(m_registry.lineIndexOf(alarm.port))
                               : SiteItem::sensor(m_registry.indexOf(alarm.number));
}

} // namespace gorizont
