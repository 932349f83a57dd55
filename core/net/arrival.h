#pragma once

#include <QHostAddress>

namespace gorizont {

/// A connection that was just accepted.
struct Arrival
{
    int descriptor = -1; ///< non-blocking; whoever is given the arrival closes it
    QHostAddress address;
    quint16 port = 0; ///< of the client
};

} // namespace gorizont
