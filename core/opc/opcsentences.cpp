#include "core/opc/opcsentences.h"

#include <QCoreApplication>

namespace gorizont::opcsentences {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(OpcSentences)
};

} // namespace

QString listening(quint16 port)
{
#ifdef Q_OS_WIN
    return Text::tr("OPC DA: gateways of this computer are fed on port %1.").arg(port);
#else
    return Text::tr("OPC DA needs Windows; here only the feed for a gateway gorizont-opc-da works, on port %1 of "
                    "this computer.")
        .arg(port);
#endif
}

QString full(std::size_t gateways)
{
    return Text::tr("OPC DA: a gateway was refused, %1 are connected already. One gateway serves any number of OPC "
                    "clients; end those that are not needed.")
        .arg(gateways);
}

QString malformed()
{
    return Text::tr("OPC DA: a client was disconnected, it is no gateway of this program (a line of more than 4096 "
                    "bytes). Look what else uses the port given by [OPC] Port.");
}

QString stalled()
{
    return Text::tr(
        "OPC DA: a gateway was disconnected, it takes nothing any more. It connects again by itself; if not, "
        "end gorizont-opc-da in the task manager.");
}

QString oldRegistration()
{
    return Text::tr(
        "OPC DA: the gateway was registered with another list of tags. Start the program once as administrator, "
        "and let the SCADA system read the list of tags anew.");
}

} // namespace gorizont::opcsentences
