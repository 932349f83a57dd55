#pragma once

#include "core/net/clientinfo.h"

#include <QPointer>
#include <QWidget>

class QMessageBox;
class QPushButton;

namespace gorizont {

class ClientModel;
class RowOrder;
class TableView;

/// The tab <Клиенты>: who is connected to the data servers, and the means to cut somebody off. GUI thread.
class ClientsPage : public QWidget
{
    Q_OBJECT

public:
    explicit ClientsPage(QWidget *parent = nullptr);

    /// All clients of \a service as they are now.
    void setClients(const QString &service, const QList<ClientInfo> &clients);
    void refresh(UtcTime now);

Q_SIGNALS:
    /// The user has confirmed that this connection is to be cut off.
    void dismissed(const QString &service, const QHostAddress &address, quint16 port);

private:
    void setColumns();
    void addDismissal();
    void askDismissal();

    ClientModel *m_model;
    RowOrder *m_order;
    TableView *m_view;
    QPushButton *m_dismiss;
    QPointer<QMessageBox> m_question; ///< while it waits for an answer
};

} // namespace gorizont
