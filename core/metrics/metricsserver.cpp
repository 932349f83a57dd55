#include "core/metrics/metricsserver.h"

#include <QCoreApplication>
#include <QHostAddress>
#include <QTcpServer>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <microhttpd.h>
#include <unistd.h>

namespace gorizont {

namespace {

constexpr std::size_t connectionMemory = 32768; ///< bytes, for request and headers

struct Page
{
    unsigned status = MHD_HTTP_OK;
    QByteArray text;
    const char *allow = nullptr;
};

Page pageFor(const MetricsBoard &board, const char *path, const char *method)
{
    if (std::strcmp(path, "/metrics") != 0) {
        return {MHD_HTTP_NOT_FOUND, QByteArrayLiteral("There is /metrics only.\n")};
    }
    if (std::strcmp(method, MHD_HTTP_METHOD_GET) != 0 && std::strcmp(method, MHD_HTTP_METHOD_HEAD) != 0) {
        return {MHD_HTTP_METHOD_NOT_ALLOWED, QByteArrayLiteral("GET only.\n"), "GET, HEAD"};
    }
    return {MHD_HTTP_OK, expositionText(board.families(SteadyTime::clock::now()))};
}

/// Called by the thread of the library, first with the headers, then with each piece of a body, at last without one.
MHD_Result answer(
    void *board, MHD_Connection *connection, const char *path, const char *method, const char *, const char *,
    std::size_t *bodySize, void **state)
{
    static int seen = 0;
    if (*state == nullptr) {
        *state = &seen;
        return MHD_YES;
    }
    if (*bodySize > 0) {
        *bodySize = 0; // whatever it is
        return MHD_YES;
    }
    const Page page = pageFor(*static_cast<const MetricsBoard *>(board), path, method);
    QByteArray text = page.text;
    MHD_Response *response =
        MHD_create_response_from_buffer(static_cast<std::size_t>(text.size()), text.data(), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) {
        return MHD_NO;
    }
    const bool isMetrics = page.status == MHD_HTTP_OK;
    MHD_add_response_header(
        response, MHD_HTTP_HEADER_CONTENT_TYPE,
        isMetrics ? "text/plain; version=0.0.4; charset=utf-8" : "text/plain; charset=utf-8");
    if (page.allow != nullptr) {
        MHD_add_response_header(response, MHD_HTTP_HEADER_ALLOW, page.allow);
    }
    const MHD_Result result = MHD_queue_response(connection, page.status, response);
    MHD_destroy_response(response);
    return result;
}

QString remedy(QAbstractSocket::SocketError error)
{
    switch (error) {
    case QAbstractSocket::AddressInUseError:
        return QCoreApplication::translate(
            "Metrics", "Another program uses this port. Stop that program or choose another Port in [Metrics].");
    case QAbstractSocket::SocketAccessError:
        return QCoreApplication::translate(
            "Metrics", "Ports below 1024 need a right. Choose another Port in [Metrics].");
    case QAbstractSocket::SocketAddressNotAvailableError:
        return QCoreApplication::translate(
            "Metrics", "This computer does not have the address given in Bind of [Metrics].");
    default: return QCoreApplication::translate("Metrics", "Check Port and Bind in [Metrics].");
    }
}

} // namespace

void MetricsServer::Stop::operator()(MHD_Daemon *daemon) const
{
    MHD_stop_daemon(daemon);
}

MetricsServer::MetricsServer(const Settings &settings, const QList<LineConfig> &lines, QObject *parent)
    : QObject(parent)
    , m_settings(settings)
    , m_board(lines)
    , m_retry(this)
{
    m_retry.setInterval(settings.retry);
    connect(&m_retry, &QTimer::timeout, this, &MetricsServer::tryToServe);
}

MetricsServer::~MetricsServer() = default;

void MetricsServer::start()
{
    if (QHostAddress(m_settings.metrics.bind).isNull()) {
        // Listening everywhere instead would serve those whom somebody meant to keep out.
        tell(
            JournalKind::Error,
            QCoreApplication::translate(
                "Metrics",
                "Metrics: \"%1\" in Bind of [Metrics] is not an IP address. Not serving until it is corrected.")
                .arg(m_settings.metrics.bind));
        return;
    }
    m_retry.start();
    tryToServe();
}

void MetricsServer::stop()
{
    m_retry.stop();
    m_told.reset();
    m_daemon.reset();
    m_port = 0;
}

/// Qt opens the port, because it says best why it cannot; the library gets it listening.
void MetricsServer::tryToServe()
{
    QTcpServer opener;
    if (!opener.listen(QHostAddress(m_settings.metrics.bind), static_cast<quint16>(m_settings.metrics.port))) {
        fail(opener.serverError(), opener.errorString());
        return;
    }
    opener.pauseAccepting();
    const int listening = ::fcntl(static_cast<int>(opener.socketDescriptor()), F_DUPFD_CLOEXEC, 0);
    m_daemon.reset(MHD_start_daemon(
        MHD_USE_AUTO_INTERNAL_THREAD, 0, nullptr, nullptr, answer, &m_board, MHD_OPTION_LISTEN_SOCKET, listening,
        MHD_OPTION_CONNECTION_LIMIT, m_settings.clients, MHD_OPTION_CONNECTION_TIMEOUT,
        static_cast<unsigned>(m_settings.idle.count()), MHD_OPTION_CONNECTION_MEMORY_LIMIT, connectionMemory,
        MHD_OPTION_END));
    if (!m_daemon) {
        const QString reason = qt_error_string(errno);
        ::close(listening);
        fail(QAbstractSocket::UnknownSocketError, reason);
        return;
    }
    m_retry.stop();
    m_told.reset();
    m_port = opener.serverPort();
    tell(
        JournalKind::On,
        QCoreApplication::translate("Metrics", "Metrics: serving http://%1:%2/metrics.")
            .arg(
                m_settings.metrics.bind.contains(u':') ? u'[' + m_settings.metrics.bind + u']'
                                                       : m_settings.metrics.bind)
            .arg(m_port));
}

void MetricsServer::fail(QAbstractSocket::SocketError error, const QString &reason)
{
    if (m_told == error) {
        return;
    }
    m_told = error;
    tell(
        JournalKind::Error,
        QCoreApplication::translate("Metrics", "Metrics: cannot serve on port %1 (%2). %3 Trying again every %4 s.")
            .arg(QString::number(m_settings.metrics.port), reason, remedy(error))
            .arg(std::chrono::ceil<std::chrono::seconds>(m_settings.retry).count()));
}

void MetricsServer::tell(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, utcNow(), text});
}

} // namespace gorizont
