#pragma once
#include "app/opc-da/com/gate.h"
#include "app/opc-da/com/settings.h"

namespace opcda {

/// Reads the feed of the main program on a thread of its own, for as long as the process lives: connects, reconnects every
/// 2 s, treats 6 s of silence as the end of a connection.
class FeedClient
{
public:
    /// `ready` is set when the first list of tags and its values are there, `ended` when the main program ends for good.
    FeedClient(Gate &gate, Settings settings, HANDLE ready, HANDLE ended);

    void run();

private:
    /// True when the main program has said that it ends.
    bool converse(SOCKET socket);
    TagBook::Answer take(std::string_view line);

    Gate &m_gate;
    const Settings m_settings;
    HANDLE m_ready;
    HANDLE m_ended;
    bool m_hasList = false; ///< the next line of values is the first snapshot
};

} // namespace opcda
