#include "app/tool/readcommand.h"

#include "app/tool/output.h"

namespace gorizont::tool {

ExitCode readRepeatedly(Session &session, const TakeReading &take)
{
    const Options &options = session.options();
    const bool isEndless = options.count == 0;
    ExitCode code = ExitGood;
    auto due = std::chrono::steady_clock::now();
    for (int i = 0; isEndless || i < options.count; ++i) {
        if (i > 0) {
            due += options.interval;
            const auto left = due - std::chrono::steady_clock::now();
            if (!session.wait(std::chrono::duration_cast<std::chrono::milliseconds>(left))) {
                return isEndless ? code : session.fail(Fault::Cancelled, options.address);
            }
        }
        QJsonObject object = session.object(options.address);
        object.insert(QStringLiteral("time"), timestamp());
        const auto text = take(object);
        if (text) {
            session.tell(*text, object);
        } else if (text.fault() == Fault::Cancelled && isEndless) {
            return code;
        } else {
            code = session.fail(text.fault(), options.address);
            if (isLineFault(text.fault())) {
                return code;
            }
        }
    }
    return code;
}

} // namespace gorizont::tool
