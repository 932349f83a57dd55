#include "app/tool/scancommand.h"

#include "app/tool/output.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "core/devices/addressscan.h"

namespace gorizont::tool {

namespace {

void showUnclear(const Session &session, int address, Fault fault)
{
    QJsonObject object = session.object(address);
    object.insert(QStringLiteral("fault"), faultName(fault));
    session.tell(
        Text::tr("%1  somebody answers, but not clearly (%2); two sensors with one address?")
            .arg(address, 3)
            .arg(faultText(fault)),
        object);
}

/// Ends before the last address only when the line is gone or the user wants it.
Result<void> probeAll(const Session &session, const ScanSteps &steps, AddressScan &scan)
{
    for (int address = scan.next(); address != 0; address = scan.next()) {
        showProgress(
            Text::tr("address %1, %n sensor(s) found", nullptr, static_cast<int>(scan.found().size())).arg(address));
        const auto probed = steps.probe(address);
        if (!probed && isLineFault(probed.fault())) {
            return probed;
        }
        scan.record(probed);
        if (probed) {
            steps.show(address);
        } else if (probed.fault() != Fault::Timeout) {
            showUnclear(session, address, probed.fault());
        }
    }
    return {};
}

} // namespace

void showUnreadable(const Session &session, int address, Fault fault)
{
    QJsonObject object = session.object(address);
    object.insert(QStringLiteral("fault"), faultName(fault));
    session.tell(QStringLiteral("%1  ").arg(address, 3) + Text::tr("its settings cannot be read"), object);
}

ExitCode scanLine(Session &session, const ScanSteps &steps)
{
    AddressScan scan(session.options().from, session.options().to);
    const auto done = probeAll(session, steps, scan);
    showProgress({});
    if (!session.options().isJson) {
        complain(
            Text::tr("%n sensor(s) found", nullptr, static_cast<int>(scan.found().size())) + QStringLiteral("; ")
            + Text::tr("%n address(es) asked", nullptr, scan.probed()));
    }
    if (!done) {
        return session.fail(done.fault(), scan.next());
    }
    return scan.found().isEmpty() ? ExitNoAnswer : ExitGood;
}

} // namespace gorizont::tool
