// Function 04 × 122 registers on the loopback, every answer verified: our server beside QModbusTcpServer, a libmodbus
// select() server and a bare epoll responder, each in a process of its own. `bench_modbus [ROUNDS [SECONDS]]`: the
// servers take turns of SECONDS, ROUNDS times; printed are the medians, and the median of the ratios within a round.
// Build it with the preset release.
#include "tests/bench/modbus/loadgenerator.h"
#include "tests/bench/modbus/serverprocess.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

using namespace gorizont::bench;

namespace {

struct Case
{
    int connections;
    int inFlight;
};

constexpr Case cases[] = {{8, 1}, {64, 1}, {256, 1}, {8, 8}};
constexpr std::size_t contenderCount = std::size(contenders);
constexpr double warmUp = 0.1; ///< s

struct Figures
{
    double perSecond = 0; ///< requests
    double cpu = 0; ///< µs of the server per request
};

using Round = std::array<Figures, contenderCount>;

Figures measure(const Contender &contender, const Case &which, double seconds)
{
    using Clock = std::chrono::steady_clock;
    const ServerProcess server(contender);
    LoadGenerator load(server.port(), which.connections, which.inFlight);
    load.run(std::chrono::duration<double>(warmUp));
    const double cpu = server.cpuSeconds();
    const auto begin = Clock::now();
    const auto answers = static_cast<double>(load.run(std::chrono::duration<double>(seconds)));
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    if (load.hasFailed() || answers == 0) {
        std::fprintf(stderr, "%s: a wrong answer or none\n", contender.name);
        std::exit(1);
    }
    return {answers / took, 1e6 * (server.cpuSeconds() - cpu) / answers};
}

template <typename Value> double median(const std::vector<Round> &rounds, Value value)
{
    std::vector<double> values;
    values.reserve(rounds.size());
    for (const Round &round : rounds) {
        values.push_back(value(round));
    }
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void print(const Case &which, const std::vector<Round> &rounds)
{
    std::printf("%d connections, %d in flight\n", which.connections, which.inFlight);
    std::printf("  %-18s %12s %12s %14s\n", "", "requests/s", "µs CPU each", "ours / this");
    for (std::size_t i = 0; i < contenderCount; ++i) {
        const double perSecond = median(rounds, [i](const Round &round) { return round[i].perSecond; });
        const double cpu = median(rounds, [i](const Round &round) { return round[i].cpu; });
        const double ratio =
            median(rounds, [i](const Round &round) { return round[0].perSecond / round[i].perSecond; });
        std::printf("  %-18s %12.0f %12.2f %13.2f\n", contenders[i].name, perSecond, cpu, ratio);
    }
    std::fflush(stdout);
}

int serve(const char *name, int argc, char **argv)
{
    for (const Contender &contender : contenders) {
        if (std::strcmp(contender.name, name) == 0) {
            return contender.serve(argc, argv);
        }
    }
    return 2;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc == 3 && std::strcmp(argv[1], "serve") == 0) {
        return serve(argv[2], argc, argv);
    }
    const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
    const double seconds = argc > 2 ? std::max(0.1, std::atof(argv[2])) : 0.7;
    for (const Case &which : cases) {
        std::vector<Round> rounds(static_cast<std::size_t>(count));
        for (Round &round : rounds) {
            for (std::size_t i = 0; i < contenderCount; ++i) {
                round[i] = measure(contenders[i], which, seconds);
            }
        }
        print(which, rounds);
    }
    return 0;
}
