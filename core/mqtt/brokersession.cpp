#include "core/mqtt/brokersession.h"

#include <QDeadlineTimer>
#include <QFile>
#include <QHostInfo>
#include <QLoggingCategory>

#include <cerrno>
#include <mosquitto.h>
#include <utility>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logServer, "gorizont.server", QtInfoMsg)

using namespace std::chrono_literals;

constexpr auto farewellLimit = 300ms;

void startLibrary()
{
    static const int outcome = mosquitto_lib_init();
    Q_UNUSED(outcome);
}

bool isReadable(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly);
}

/// A key that asks for a password would ask on the terminal.
int noKeyPassword(char *, int, int, void *)
{
    return 0;
}

} // namespace

void BrokerSession::Destroy::operator()(mosquitto *client) const
{
    mosquitto_destroy(client);
}

BrokerSession::BrokerSession(const Access &access, QObject *parent)
    : QObject(parent)
    , m_access(access)
    , m_round(this)
    , m_limit(this)
{
    startLibrary();
    m_round.setInterval(1000);
    connect(&m_round, &QTimer::timeout, this, [this] {
        const int outcome = mosquitto_loop_misc(m_client.get());
        settle(outcome == MOSQ_ERR_SUCCESS ? mosquitto_loop_read(m_client.get(), 1) : outcome);
    });
    m_limit.setSingleShot(true);
    m_limit.setInterval(access.limit);
    connect(&m_limit, &QTimer::timeout, this, [this] { end(BrokerTrouble::NoAnswer, {}); });
}

BrokerSession::~BrokerSession()
{
    drop();
}

void BrokerSession::open()
{
    drop();
    m_limit.start();
    m_lookup = QHostInfo::lookupHost(m_access.settings.host, this, [this](const QHostInfo &info) {
        m_lookup = -1;
        if (info.error() == QHostInfo::NoError) {
            onFound(info.addresses());
        } else {
            end(BrokerTrouble::UnknownHost, info.errorString());
        }
    });
}

void BrokerSession::onFound(const QList<QHostAddress> &addresses)
{
    m_client.reset(mosquitto_new(m_access.settings.clientId.toUtf8().constData(), true, this));
    if (!m_client) {
        end(BrokerTrouble::Rejected, qt_error_string(errno));
        return;
    }
    if (!prepare()) {
        return; // it has ended
    }
    const QByteArray family = ownFamily(addresses);
    ++m_attempts;
    const int outcome = mosquitto_connect_bind_async(
        m_client.get(), m_access.settings.host.toUtf8().constData(), m_access.settings.port,
        static_cast<int>(m_access.keepAlive.count()), family.isEmpty() ? nullptr : family.constData());
    if (outcome == MOSQ_ERR_SUCCESS) {
        m_round.start();
    }
    settle(outcome);
}

/// The library tries one address only when it does not wait. Of a name with addresses of both families each has its
/// turn: a socket bound to "any" of one family cannot connect to the other.
QByteArray BrokerSession::ownFamily(const QList<QHostAddress> &addresses) const
{
    const auto isOfFirst = [&](const QHostAddress &address) {
        return address.protocol() == addresses.first().protocol();
    };
    if (std::all_of(addresses.begin(), addresses.end(), isOfFirst)) {
        return {};
    }
    const bool firstIsV6 = addresses.first().protocol() == QAbstractSocket::IPv6Protocol;
    const bool takesFirst = m_attempts % 2 == 0;
    return takesFirst == firstIsV6 ? QByteArrayLiteral("::") : QByteArrayLiteral("0.0.0.0");
}

bool BrokerSession::prepare()
{
    mosquitto *client = m_client.get();
    mosquitto_connect_callback_set(client, [](mosquitto *, void *self, int answer) {
        static_cast<BrokerSession *>(self)->m_answer = answer;
    });
    mosquitto_publish_callback_set(client, [](mosquitto *, void *self, int message) {
        static_cast<BrokerSession *>(self)->m_delivered.append(message);
    });
    mosquitto_log_callback_set(client, [](mosquitto *, void *self, int level, const char *text) {
        qCDebug(logServer) << "mqtt" << text;
        if (level == MOSQ_LOG_ERR) {
            static_cast<BrokerSession *>(self)->m_complaint = QString::fromUtf8(text);
        }
    });
    mosquitto_max_inflight_messages_set(client, static_cast<unsigned>(m_access.window));
    mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY, 1);
    const QByteArray will = QByteArrayLiteral("offline");
    mosquitto_will_set(
        client, m_access.willTopic.constData(), static_cast<int>(will.size()), will.constData(), 1, true);
    return prepareUser() && prepareTls();
}

bool BrokerSession::prepareUser()
{
    const MqttSettings &settings = m_access.settings;
    QByteArray password = settings.password.toUtf8();
    if (!settings.passwordFile.isEmpty()) {
        QFile file(settings.passwordFile);
        if (!file.open(QIODevice::ReadOnly)) {
            end(BrokerTrouble::UnreadableFile, settings.passwordFile + QStringLiteral(": ") + file.errorString());
            return false;
        }
        constexpr qint64 longest = 65536;
        password = file.readLine(longest);
        while (password.endsWith('\n') || password.endsWith('\r')) {
            password.chop(1);
        }
    }
    if (!settings.user.isEmpty()) {
        mosquitto_username_pw_set(m_client.get(), settings.user.toUtf8().constData(), password.constData());
    }
    return true;
}

bool BrokerSession::prepareTls()
{
    const MqttSettings &settings = m_access.settings;
    if (!settings.usesTls) {
        return true;
    }
    for (const QString &path : {settings.caFile, settings.certFile, settings.keyFile}) {
        if (!path.isEmpty() && !isReadable(path)) {
            end(BrokerTrouble::UnreadableFile, path);
            return false;
        }
    }
    const QByteArray ca = QFile::encodeName(settings.caFile);
    const QByteArray cert = QFile::encodeName(settings.certFile);
    const QByteArray key = QFile::encodeName(settings.keyFile);
    const auto orNull = [](const QByteArray &name) { return name.isEmpty() ? nullptr : name.constData(); };
    const int outcome = mosquitto_tls_set(
        m_client.get(), orNull(ca), ca.isEmpty() ? "/etc/ssl/certs" : nullptr, orNull(cert), orNull(key),
        noKeyPassword);
    if (outcome != MOSQ_ERR_SUCCESS) {
        end(BrokerTrouble::TlsFailed, detailOf(outcome));
        return false;
    }
    return true;
}

std::optional<int> BrokerSession::publish(const QByteArray &topic, const QByteArray &payload, bool isRetained)
{
    if (!m_isConnected) {
        return std::nullopt;
    }
    int message = 0;
    const int outcome = mosquitto_publish(
        m_client.get(), &message, topic.constData(), static_cast<int>(payload.size()), payload.constData(),
        m_access.settings.qos, isRetained);
    watch();
    if (outcome != MOSQ_ERR_SUCCESS || !m_delivered.isEmpty()) {
        settleLater(outcome);
    }
    return outcome == MOSQ_ERR_SUCCESS ? std::optional(message) : std::nullopt;
}

void BrokerSession::settleLater(int outcome)
{
    QMetaObject::invokeMethod(
        this,
        [this, outcome, client = m_client.get()] {
            if (client == m_client.get()) {
                settle(outcome);
            }
        },
        Qt::QueuedConnection);
}

void BrokerSession::watch()
{
    const int socket = mosquitto_socket(m_client.get());
    if (socket < 0) {
        stopWatching();
        return;
    }
    if (!m_reads || m_reads->socket() != socket) {
        m_reads = std::make_unique<QSocketNotifier>(socket, QSocketNotifier::Read);
        m_writes = std::make_unique<QSocketNotifier>(socket, QSocketNotifier::Write);
        connect(m_reads.get(), &QSocketNotifier::activated, this, [this] {
            settle(mosquitto_loop_read(m_client.get(), 1));
        });
        connect(m_writes.get(), &QSocketNotifier::activated, this, [this] {
            settle(mosquitto_loop_write(m_client.get(), 1));
        });
    }
    m_writes->setEnabled(mosquitto_want_write(m_client.get()));
}

void BrokerSession::stopWatching()
{
    for (auto *notifier : {&m_reads, &m_writes}) {
        if (*notifier) {
            (*notifier)->setEnabled(false);
            notifier->release()->deleteLater(); // this may be its own slot
        }
    }
}

/// Comes after every call of the library that may have reported something, never within one.
void BrokerSession::settle(int outcome)
{
    const QList<int> delivered = std::exchange(m_delivered, {});
    const auto answer = std::exchange(m_answer, std::nullopt);
    if (answer == 0) {
        m_isConnected = true;
        m_attempts = m_attempts > 0 ? m_attempts - 1 : 0; // the next one begins with the family that worked
        m_limit.stop();
        Q_EMIT connected();
    }
    if (m_client && !delivered.isEmpty()) {
        Q_EMIT published(delivered);
    }
    if (!m_client) {
        return;
    }
    if (answer.value_or(0) != 0) {
        outcome = *answer;
        end(outcome == 4       ? BrokerTrouble::WrongPassword
                : outcome == 5 ? BrokerTrouble::NotAuthorized
                               : BrokerTrouble::Rejected,
            QString::fromUtf8(mosquitto_connack_string(outcome)));
    } else if (outcome != MOSQ_ERR_SUCCESS) {
        end(troubleOf(outcome), detailOf(outcome));
    } else {
        watch();
    }
}

BrokerTrouble BrokerSession::troubleOf(int outcome) const
{
    if (m_complaint.contains(QStringLiteral("certificate verify failed"))
        || m_complaint.contains(QStringLiteral("host name verification failed"))) {
        return BrokerTrouble::NotTrusted;
    }
    if (outcome == MOSQ_ERR_TLS) {
        return BrokerTrouble::TlsFailed;
    }
    return m_isConnected ? BrokerTrouble::Lost : BrokerTrouble::Unreachable;
}

QString BrokerSession::detailOf(int outcome) const
{
    if (!m_complaint.isEmpty()) {
        return m_complaint;
    }
    return outcome == MOSQ_ERR_ERRNO ? qt_error_string(errno) : QString::fromUtf8(mosquitto_strerror(outcome));
}

void BrokerSession::end(BrokerTrouble trouble, const QString &detail)
{
    drop();
    Q_EMIT ended(trouble, detail);
}

void BrokerSession::close(const QByteArray &lastWords)
{
    if (m_isConnected) {
        mosquitto_publish(
            m_client.get(), nullptr, m_access.willTopic.constData(), static_cast<int>(lastWords.size()),
            lastWords.constData(), 0, true);
        mosquitto_disconnect(m_client.get());
        const QDeadlineTimer deadline(farewellLimit);
        while (!deadline.hasExpired() && mosquitto_socket(m_client.get()) >= 0
               && mosquitto_want_write(m_client.get())) {
            mosquitto_loop(m_client.get(), 20, 1);
        }
    }
    drop();
}

void BrokerSession::drop()
{
    if (m_lookup >= 0) {
        QHostInfo::abortHostLookup(std::exchange(m_lookup, -1));
    }
    m_round.stop();
    m_limit.stop();
    stopWatching();
    m_client.reset();
    m_isConnected = false;
    m_answer.reset();
    m_delivered.clear();
    m_complaint.clear();
}

} // namespace gorizont
