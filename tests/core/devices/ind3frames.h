#pragma once

#include "core/devices/ind3/ind3service.h"
#include "tests/support/fakeline.h"

#include <QTest>

/// What a sensor at address 1 is asked and answers: frames of spec/ind3.md; those that it does not have were assembled by
/// another program.
namespace gorizont::ind3::test {

using namespace gorizont::test;
using namespace std::chrono_literals;

inline Timing timing()
{
    Timing timing;
    timing.readCommand = 200ms;
    return timing;
}

inline const Service service(timing(), Dialect::V211);
inline const Service modbusService(timing(), Dialect::Modbus);

inline const QByteArray askVersion = hex("7E 9B 0E 01 94 7E");
inline const QByteArray version = hex("7E 9B 0E 01 76 32 2E 31 31 FE 7E");
inline const QByteArray askOffset = hex("7E 9C 05 01 98 7E");
inline const QByteArray offset = hex("7E 9C 05 01 80 0A 80 20 05 00 B7 7E");
inline const QByteArray askTicks = hex("7E 9C 0C 01 91 7E");
inline const QByteArray ticks32 = hex("7E 9C 0C 01 05 94 7E");
inline const QByteArray ticks64 = hex("7E 9C 0C 01 06 97 7E");
inline const QByteArray setTicks64 = hex("7E 9C 0D 01 06 96 7E");
inline const QByteArray ticksSet = hex("7E 9C 0D 01 90 7E");
inline const QByteArray askTilt1 = hex("7E 9B 01 01 9B 7E");
inline const QByteArray tilt1 = hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E");
inline const QByteArray askTilt2 = hex("7E 9B 01 02 98 7E");
inline const QByteArray tilt2 = hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E");
inline const QByteArray setAddress2 = hex("7E 9C 09 01 02 96 7E");
inline const QByteArray addressSet = hex("7E 9C 09 02 97 7E");
inline const QByteArray broken = hex("7E 9B 01 02 6A 77 80 38 C2 00 FE 7E");
inline const QByteArray silence;

inline const QByteArray modbusAskSettings = hex("01 03 00 14 00 08 04 08");
inline const QByteArray modbusSettings = hex("01 03 10 00 04 00 01 00 02 00 05 10 30 00 01 00 00 07 5F 98 F4");
inline const QByteArray modbusSettings64 = hex("01 03 10 00 04 00 01 00 02 00 06 10 30 00 01 00 00 07 5F 8C 04");
inline const QByteArray modbusAskOffset = hex("01 03 00 1E 00 04 24 0F");
inline const QByteArray modbusOffset = hex("01 03 08 FF FF D6 FC 00 00 14 05 59 3D");
inline const QByteArray modbusAskTilt2 = hex("02 04 00 00 00 04 F1 FA");
inline const QByteArray modbusTilt2 = hex("02 04 08 FF FE 2D 8A 00 02 F6 AB 43 FF");
inline const QByteArray modbusSetTicks = hex("01 10 00 17 00 01 02 00 06 25 75");

inline Settings settingsOfTheSpec()
{
    Settings settings;
    settings.address = 1;
    settings.version = QStringLiteral("v2.11");
    settings.revision.number = 199;
    settings.serialNumber = 1887;
    settings.baud = 9600;
    settings.name = QStringLiteral("NO NAME");
    settings.offset = Tilt{5.125, -10.5};
    settings.ticks = 32;
    settings.period = 50ms;
    return settings;
}

/// What the sensor of the spec is asked after its version, up to its offset.
inline void expectMiddle(FakeLine &line, qsizetype pieces = 100)
{
    line.expectInPieces(hex("7E 9C 0A 01 97 7E"), hex("7E 9C 0A 01 C7 00 50 7E"), pieces);
    line.expectInPieces(hex("7E 9C 0B 01 96 7E"), hex("7E 9C 0B 01 5F 07 00 00 CE 7E"), pieces);
    line.expectInPieces(hex("7E 9C 01 01 9C 7E"), hex("7E 9C 01 01 04 98 7E"), pieces);
    line.expectInPieces(hex("7E 9C 03 01 9E 7E"), hex("7E 9C 03 01 4E 4F 20 4E 41 4D 45 B8 7E"), pieces);
    line.expectInPieces(askTicks, ticks32, pieces);
    line.expectInPieces(hex("7E 9C 0E 01 93 7E"), hex("7E 9C 0E 01 02 91 7E"), pieces);
}

inline void expectThrice(FakeLine &line, const QByteArray &request, const QByteArray &answer)
{
    line.expect(request, answer).expect(request, answer).expect(request, answer);
}

inline bool isClean(const FakeLine &line)
{
    return line.isDone() && line.complaints().isEmpty();
}

inline Changes ticksOnly(int ticks)
{
    Changes changes;
    changes.ticks = ticks;
    return changes;
}

} // namespace gorizont::ind3::test
