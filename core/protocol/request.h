#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>

namespace gorizont {

/// What a codec gives for one question to a device: the bytes to send, and how its answer is found among what arrives.
struct Request
{
    QByteArray bytes;
    ScanFunction scan;
};

} // namespace gorizont
