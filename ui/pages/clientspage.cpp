#include "ui/pages/clientspage.h"

#include "ui/models/clientmodel.h"
#include "ui/pages/roworder.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMessageBox>
#include <QPushButton>

namespace gorizont {

ClientsPage::ClientsPage(QWidget *parent)
    : QWidget(parent)
    , m_model(new ClientModel(this))
    , m_order(new RowOrder(m_model, ClientModel::SortRole, this))
    , m_view(new TableView(QStringLiteral("clientsTable"), this))
    , m_dismiss(new QPushButton(tr("&Disconnect…"), this))
{
    m_view->setModel(m_order);
    m_view->horizontalHeader()->setSectionsMovable(true);
    m_view->setEmptyText(tr("Nobody is connected."));
    setColumns();
    addDismissal();
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(TableColumns::sideMargin, 0, TableColumns::sideMargin, TableColumns::sideMargin);
    buttons->addStretch();
    buttons->addWidget(m_dismiss);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view, 1);
    layout->addLayout(buttons);
}

void ClientsPage::setColumns()
{
    TableColumns &columns = m_view->columns();
    columns.setDefaultSort(ClientModel::Since);
    columns.setSample(ClientModel::Service, QStringLiteral("Modbus TCP"));
    columns.setSample(ClientModel::Since, QStringLiteral("00:00:00 00.00.00"));
    columns.setSample(ClientModel::Requests, QStringLiteral("1000000000"));
    columns.setSample(ClientModel::LastRequest, QStringLiteral("100:00:00"));
    columns.setSample(ClientModel::Errors, QStringLiteral("1000000"));
    columns.setSample(ClientModel::Received, QStringLiteral("1000000000000"));
    columns.setSample(ClientModel::Sent, QStringLiteral("1000000000000"));
    columns.setElastic(ClientModel::Address, QStringLiteral("255.255.255.255:65535"));
}

void ClientsPage::addDismissal()
{
    auto *action = new QAction(m_dismiss->text(), this);
    action->setObjectName(QStringLiteral("dismissAction"));
    action->setShortcut(QKeySequence::Delete);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_view->addAction(action);
    m_dismiss->setObjectName(QStringLiteral("dismissButton"));
    m_dismiss->setAutoDefault(false);
    const auto update = [this, action] {
        const bool isChosen = m_view->selectionModel()->hasSelection();
        action->setEnabled(isChosen);
        m_dismiss->setEnabled(isChosen);
    };
    update();
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, update);
    connect(action, &QAction::triggered, this, &ClientsPage::askDismissal);
    connect(m_dismiss, &QPushButton::clicked, this, &ClientsPage::askDismissal);
}

/// Returns at once. Clients come and go while the question is open; those it names are cut off, whatever row they are in.
void ClientsPage::askDismissal()
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (rows.isEmpty() || m_question) {
        return;
    }
    std::vector<ClientModel::Client> chosen;
    for (const QModelIndex &row : rows) {
        chosen.push_back(m_model->client(m_order->mapToSource(row).row()));
    }
    const QString text = chosen.size() == 1
        ? tr("Disconnect the client %1 from %2?").arg(clientTitle(chosen.front().info), chosen.front().service)
        : tr("Disconnect %n client(s)?", nullptr, static_cast<int>(chosen.size()));
    m_question = new QMessageBox(QMessageBox::Question, window()->windowTitle(), text, {}, this);
    m_question->setObjectName(QStringLiteral("dismissQuestion"));
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    m_question->setInformativeText(tr("A client may connect again at once; ModbusAllow keeps it out for good."));
    QPushButton *yes = m_question->addButton(tr("&Disconnect"), QMessageBox::YesRole);
    yes->setObjectName(QStringLiteral("dismissYes"));
    QPushButton *no = m_question->addButton(tr("&Cancel"), QMessageBox::NoRole);
    no->setObjectName(QStringLiteral("dismissNo"));
    m_question->setDefaultButton(no);
    m_question->setEscapeButton(no);
    connect(yes, &QPushButton::clicked, this, [this, chosen] {
        for (const ClientModel::Client &client : chosen) {
            Q_EMIT dismissed(client.service, client.info.address, client.info.port);
        }
    });
    m_question->open();
}

void ClientsPage::setClients(const QString &service, const QList<ClientInfo> &clients)
{
    m_model->setClients(service, clients);
}

void ClientsPage::refresh(UtcTime now)
{
    m_model->refresh(now);
}

} // namespace gorizont
