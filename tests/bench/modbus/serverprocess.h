#pragma once

#include "tests/bench/modbus/servers.h"

#include <sys/types.h>

namespace gorizont::bench {

/// One server in a process of its own: this program again, with `serve NAME`. Ends with the object.
class ServerProcess
{
public:
    explicit ServerProcess(const Contender &contender);
    ~ServerProcess();
    ServerProcess(const ServerProcess &) = delete;
    ServerProcess &operator=(const ServerProcess &) = delete;

    int port() const { return m_port; } ///< 0: it did not start
    double cpuSeconds() const; ///< of all its threads, user and system

private:
    pid_t m_process = -1;
    int m_port = 0;
};

} // namespace gorizont::bench
