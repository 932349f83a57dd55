#include "core/protocol/mbap.h"

#include "core/protocol/bytes.h"

namespace gorizont {

Scan scanMbap(QByteArrayView bytes)
{
    const auto field = readBig<quint16>(bytes, 4);
    if (!field) {
        return Scan::incomplete();
    }
    // A wide integer: 16 bits would wrap at length FFFA, which once hung another server for good.
    const qsizetype length = *field;
    if (length < mbap::shortest || length > mbap::longest) {
        return Scan::damaged(0, mbap::lengthEnd);
    }
    const qsizetype size = mbap::lengthEnd + length;
    return bytes.size() < size ? Scan::incomplete() : Scan::complete(0, size);
}

MbapFrame readMbap(QByteArrayView frame)
{
    return {
        readBig<quint16>(frame, 0).value_or(0), readBig<quint16>(frame, 2).value_or(0), byteAt(frame, 6),
        frame.sliced(mbap::headerSize)};
}

} // namespace gorizont
