#include "app/tool/session.h"

#include "app/tool/output.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"

#include <thread>

namespace gorizont::tool {

namespace {

using namespace std::chrono_literals;

constexpr auto waitSlice = 50ms;

QString faultSentence(Fault fault, int address, const QString &lineError)
{
    switch (fault) {
    case Fault::Timeout: return Text::tr("no answer from address %1").arg(address);
    case Fault::Checksum: return Text::tr("only damaged answers from address %1").arg(address);
    case Fault::BadReply: return Text::tr("the answers from address %1 make no sense").arg(address);
    case Fault::Refused: return Text::tr("the sensor with address %1 refuses").arg(address);
    case Fault::Closed: return Text::tr("the port is lost: %1").arg(lineError);
    case Fault::Cancelled: return Text::tr("interrupted");
    }
    return {};
}

} // namespace

ExitCode exitCodeOf(Fault fault)
{
    return fault == Fault::Refused || fault == Fault::Cancelled ? ExitRefused : ExitNoAnswer;
}

QString faultText(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return Text::tr("no answer");
    case Fault::Checksum: return Text::tr("damaged answers");
    case Fault::BadReply: return Text::tr("answers without sense");
    case Fault::Refused: return Text::tr("refused");
    case Fault::Closed: return Text::tr("the port is lost");
    case Fault::Cancelled: return Text::tr("interrupted");
    }
    return {};
}

QJsonObject Session::object(int address) const
{
    const QString type = m_options.device == Device::Ind3 ? QStringLiteral("ind3")
        : m_options.device == Device::And3                ? QStringLiteral("and3")
                                                          : QStringLiteral("usm");
    return {{QStringLiteral("type"), type}, {QStringLiteral("address"), address}};
}

QJsonObject Session::outcome(const QString &setting, bool isDone) const
{
    QJsonObject result = object(m_options.address);
    result.insert(QStringLiteral("setting"), setting);
    result.insert(QStringLiteral("done"), isDone);
    return result;
}

void Session::tell(const QString &text, const QJsonObject &object) const
{
    showProgress({});
    if (m_options.isJson) {
        print(object);
    } else {
        print(text);
    }
}

ExitCode Session::fail(Fault fault, const QString &sentence, QJsonObject object) const
{
    showProgress({});
    complain(sentence);
    if (m_options.isJson) {
        object.insert(QStringLiteral("fault"), faultName(fault));
        print(object);
    }
    return exitCodeOf(fault);
}

ExitCode Session::fail(Fault fault, int address) const
{
    return fail(fault, faultSentence(fault, address, m_line.lastError().text), object(address));
}

bool Session::isAgreed(const QString &question) const
{
    return m_options.isYes || askYesNo(question, [this] { return m_line.isInterrupted(); });
}

bool Session::wait(std::chrono::milliseconds time) const
{
    const auto end = std::chrono::steady_clock::now() + time;
    while (!m_line.isInterrupted()) {
        const auto left = end - std::chrono::steady_clock::now();
        if (left <= 0s) {
            return true;
        }
        std::this_thread::sleep_for(std::min<std::chrono::steady_clock::duration>(left, waitSlice));
    }
    return false;
}

} // namespace gorizont::tool
