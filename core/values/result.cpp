#include "core/values/result.h"

namespace gorizont {

QString faultName(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return QStringLiteral("timeout");
    case Fault::Checksum: return QStringLiteral("checksum");
    case Fault::BadReply: return QStringLiteral("bad reply");
    case Fault::Refused: return QStringLiteral("refused");
    case Fault::Closed: return QStringLiteral("closed");
    case Fault::Cancelled: return QStringLiteral("cancelled");
    }
    return {};
}

} // namespace gorizont
