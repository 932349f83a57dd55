// A client of OPC DA that tries the gateway: one or more words of the list below. Ends with the number of what failed.
#include "tests/opc/client/cases.h"
#include "tests/opc/client/report.h"

#include <cstdio>
#include <cstring>

namespace {

struct Case
{
    const char *word;
    void (*run)();
};

using namespace opctest;
constexpr Case Cases[] = {
    {"registry", testRegistry}, {"server", testServer},       {"browsing", testBrowsing}, {"items", testItems},
    {"reading", testReading},   {"callbacks", testCallbacks}, {"state", testState},       {"thousand", testThousand},
    {"outage", testOutage},     {"death", testDeath},         {"shutdown", testShutdown}, {"hold", testHold},
    {"survivor", testSurvivor}, {"ending", testEnding},       {"chain", testChain},       {"alone", testListAlone},
    {"bench", runBench},
};

bool run(const char *word)
{
    for (const Case &entry : Cases) {
        if (std::strcmp(entry.word, word) == 0) {
            entry.run();
            return true;
        }
    }
    std::printf("FAIL %s is not one of the cases\n", word);
    return false;
}

} // namespace

int main(int count, char **words)
{
    CoInitializeEx(nullptr, COINIT_MULTITHREADED);
    bool isKnown = count > 1;
    for (int i = 1; i < count; ++i)
        isKnown = run(words[i]) && isKnown;
    const int failed = failures();
    std::printf("end %d\n", failed);
    CoUninitialize();
    return isKnown ? failed : 2;
}
