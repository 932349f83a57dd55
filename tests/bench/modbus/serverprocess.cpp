#include "tests/bench/modbus/serverprocess.h"

#include <csignal>
#include <cstdio>
#include <ctime>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gorizont::bench {

ServerProcess::ServerProcess(const Contender &contender)
{
    int ends[2];
    if (::pipe(ends) != 0) {
        return;
    }
    m_process = ::fork();
    if (m_process == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[0]);
        ::execl("/proc/self/exe", "bench_modbus", "serve", contender.name, nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    std::FILE *output = ::fdopen(ends[0], "r");
    if (std::fscanf(output, "%d", &m_port) != 1) {
        m_port = 0;
    }
    std::fclose(output);
}

ServerProcess::~ServerProcess()
{
    if (m_process > 0) {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
}

double ServerProcess::cpuSeconds() const
{
    clockid_t clock{};
    timespec time{};
    ::clock_getcpuclockid(m_process, &clock);
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace gorizont::bench
