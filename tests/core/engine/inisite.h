#pragma once

#include "core/config/inifile.h"
#include "core/config/serverconfig.h"
#include "core/engine/linepoller.h"
#include "tests/support/fakeline.h"

/// A port as an ini describes it, polled on a line that plays a script: from the key to its effect.
namespace gorizont::test {

inline const QByteArray askAnD3 = hex("01 C9 00 00 12 4A"); // spec/and3.md
/// X −3599.5″, Y 2720.5″, 21.38 °C, 5728 packets measured, healthy without a fan.
inline const QByteArray answerAnD3 = hex("01 C9 84 8F 04 55 E1 14 50 01 34 00 0F 24 05 CC 02 00 00 CC CF DE");
inline const QByteArray askInD3 = hex("7E 9B 01 01 9B 7E"); // spec/ind3.md
inline const QByteArray answerInD3 = hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E");

/// Settings of [Port1] in \a ini. What is not given costs no time: no pause, a cycle a millisecond.
inline PollingSettings settingsFrom(const QByteArray &ini)
{
    const QByteArray calm = "[Common]\nNumOfPorts=1\n[Port1]\nOn=1\n[Timers]\nTmRun=1\n[Sleeps]\nSIdle=0\n"
                            "SAdrChange=0\nSRError=0\nSCRCError=0\n";
    // The first of two equal keys counts.
    const ServerConfig config = readServerConfig(IniFile::fromBytes(ini + '\n' + calm)).config;
    PollingSettings settings;
    settings.line = config.lines.value(0);
    settings.timing = config.timing;
    settings.rules = {config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
    settings.gravity = config.gravity;
    settings.asksInformation = config.asksInformation;
    return settings;
}

/// The keys of \a count sensors in the section of the port. \a name ends with the index.
inline QByteArray sensorsOf(const char *name, int count = 1, const QByteArray &more = {})
{
    QByteArray ini = "[Port1]\nNumOfSensors=" + QByteArray::number(count) + '\n' + more;
    for (int i = 1; i <= count; ++i) {
        const QByteArray index = QByteArray::number(i);
        ini += "Name" + index + '=' + name + "\nOn" + index + "=1\nadr" + index + '=' + index + '\n';
    }
    return ini;
}

/// A poller that has just begun.
inline std::unique_ptr<LinePoller> startedPoller(const PollingSettings &settings)
{
    auto poller = std::make_unique<LinePoller>(settings);
    poller->lineBecame(LineState::Open);
    poller->restart();
    return poller;
}

} // namespace gorizont::test
