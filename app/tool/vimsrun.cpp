#include "app/tool/vimsrun.h"

#include "app/tool/output.h"
#include "app/tool/session.h"
#include "app/tool/terminal.h"

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

QJsonObject VimsRun::object() const
{
    return {{u"type"_s, u"L-VIMS"_s}, {u"device"_s, m_options.line.device}};
}

void VimsRun::tell(const QString &text, const QJsonObject &found) const
{
    showProgress({});
    if (m_options.isJson) {
        print(found);
    } else {
        print(text);
    }
}

ExitCode VimsRun::fail(Fault fault, const QString &sentence, const QJsonObject &more) const
{
    showProgress({});
    complain(u"%1: %2"_s.arg(m_options.line.device, sentence));
    if (m_options.isJson) {
        QJsonObject failed = object();
        failed.insert(u"fault"_s, faultName(fault));
        for (auto it = more.constBegin(); it != more.constEnd(); ++it) {
            failed.insert(it.key(), it.value());
        }
        print(failed);
    }
    return exitCodeOf(fault);
}

ExitCode VimsRun::fail(Fault fault) const
{
    return fail(fault, faultText(fault));
}

ExitCode VimsRun::usage(const QString &sentence) const
{
    complain(sentence);
    return ExitUsage;
}

bool VimsRun::isAgreed(const QString &question) const
{
    return m_options.isYes || (isInputTerminal() && askYesNo(question, [this] { return m_line.isInterrupted(); }));
}

} // namespace gorizont::tool
