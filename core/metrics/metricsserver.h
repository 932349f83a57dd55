#pragma once

#include "core/config/feedsettings.h"
#include "core/metrics/metricsboard.h"
#include "core/values/journalentry.h"

#include <QAbstractSocket>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

struct MHD_Daemon;

namespace gorizont {

/// `GET /metrics` over HTTP. Lives in the servers thread; libmicrohttpd answers in a thread of its own from a copy of
/// what is on the board. A library, because HTTP from strangers has more corners than lines are worth writing here:
/// pieces, pipelining, keep-alive, clients that dawdle. While the port cannot be had, it goes on trying.
class MetricsServer : public QObject
{
    Q_OBJECT

public:
    struct Settings
    {
        MetricsSettings metrics; ///< port 0: any free one
        std::chrono::milliseconds retry{5000}; ///< between two attempts to take the port
        unsigned clients = 32; ///< connections at a time
        std::chrono::seconds idle{10}; ///< a connection on which nothing moves is closed
    };

    explicit MetricsServer(const Settings &settings, const QList<LineConfig> &lines, QObject *parent = nullptr);
    ~MetricsServer() override;

    MetricsBoard &board() { return m_board; } ///< for any thread
    quint16 port() const { return m_port; } ///< 0: not serving

public Q_SLOTS:
    void start();
    void stop();

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);

private:
    struct Stop
    {
        void operator()(MHD_Daemon *daemon) const;
    };

    void tryToServe();
    void fail(QAbstractSocket::SocketError error, const QString &reason);
    void tell(JournalKind kind, const QString &text);

    const Settings m_settings;
    MetricsBoard m_board;
    QTimer m_retry;
    quint16 m_port = 0;
    std::optional<QAbstractSocket::SocketError> m_told; ///< why it does not serve
    std::unique_ptr<MHD_Daemon, Stop> m_daemon; ///< its thread reads the board
};

} // namespace gorizont
