#include "core/devices/ind3/ind3simulatorports.h"

namespace gorizont::ind3 {

namespace {

constexpr qsizetype mostBytes = 64; ///< more than any request, all escaped
constexpr qsizetype longestNameBytes = 16;

int byte(const QByteArray &bytes, qsizetype at)
{
    return static_cast<unsigned char>(bytes.at(at));
}

QByteArray withoutEscapes(const QByteArray &bytes)
{
    QByteArray plain;
    bool isEscaped = false;
    for (const char c : bytes) {
        if (isEscaped) {
            plain.append(static_cast<char>(c ^ 0x20));
            isEscaped = false;
        } else if (c == '\x7D') {
            isEscaped = true;
        } else {
            plain.append(c);
        }
    }
    return plain;
}

QByteArray answerFrame(int protocol, int packet, int address, const QByteArray &data)
{
    QByteArray plain = QByteArray(1, char(protocol)) + char(packet) + char(address) + data;
    char sum = 0;
    for (const char c : std::as_const(plain)) {
        sum = static_cast<char>(sum ^ c);
    }
    plain.append(sum);
    plain.replace("\x7D", "\x7D\x5D"); // first, or the next line's escapes would be escaped again
    plain.replace("\x7E", "\x7D\x5E");
    return '\x7E' + plain + '\x7E';
}

QByteArray littleEndian(quint32 value, int bytes)
{
    QByteArray result;
    for (int i = 0; i < bytes; ++i, value >>= 8) {
        result.append(static_cast<char>(value & 0xFF));
    }
    return result;
}

/// Protocol 9B. Empty: no answer.
QByteArray answerMain(int packet, const QByteArray &data, const SimulatedSensor &sensor, BuildingMotion::Time now)
{
    if (!data.isEmpty()) {
        return {};
    }
    switch (packet) {
    case 0x01: return answerFrame(0x9B, packet, sensor.address, angleBytes(sensor.angle(0, now), sensor.angle(1, now)));
    case 0x0E:
        return sensor.selfTest != 0 ? answerFrame(0x9B, 0xFF, sensor.address, QByteArray(1, char(sensor.selfTest)))
                                    : answerFrame(0x9B, packet, sensor.address, "v2.11");
    default: return {};
    }
}

/// The data of the answer to a question of protocol 9C. Empty: not a question.
QByteArray settingData(int packet, const SimulatedSensor &sensor)
{
    switch (packet) {
    case 0x01: return QByteArray(1, char(sensor.baudCode));
    case 0x03: return sensor.name;
    case 0x05: return angleBytes(sensor.offset[0], sensor.offset[1]);
    case 0x0A: return littleEndian(sensor.revision, 2);
    case 0x0B: return littleEndian(sensor.serialNumber, 4);
    case 0x0C: return QByteArray(1, char(sensor.ticksCode));
    case 0x0E: return QByteArray(1, char(sensor.periodCode));
    default: return {};
    }
}

bool takeCode(int &setting, const QByteArray &data, int least, int most)
{
    if (data.size() != 1 || byte(data, 0) < least || byte(data, 0) > most) {
        return false;
    }
    setting = byte(data, 0);
    return true;
}

/// Takes a setting over. False: not a setting, or not one that the device accepts.
bool takeSetting(int packet, const QByteArray &data, SimulatedSensor &sensor)
{
    switch (packet) {
    case 0x02: return takeCode(sensor.baudCode, data, 1, 8);
    case 0x04:
        if (data.isEmpty() || data.size() > longestNameBytes) {
            return false;
        }
        sensor.name = data;
        return true;
    case 0x06:
        if (data.size() != 6) {
            return false;
        }
        sensor.offset[0] = angleOfBytes(data.left(3));
        sensor.offset[1] = angleOfBytes(data.right(3));
        return true;
    case 0x09: return takeCode(sensor.address, data, 1, 255);
    case 0x0D: return takeCode(sensor.ticksCode, data, 0, 6);
    case 0x0F: return takeCode(sensor.periodCode, data, 0, 3);
    default: return false;
    }
}

/// Protocol 9C. The answer to a new address carries it already.
QByteArray answerAdditional(int packet, const QByteArray &data, SimulatedSensor &sensor)
{
    const QByteArray value = data.isEmpty() ? settingData(packet, sensor) : QByteArray();
    if (value.isEmpty() && !takeSetting(packet, data, sensor)) {
        return {};
    }
    return answerFrame(0x9C, packet, sensor.address, value);
}

} // namespace

QByteArray Port211::hear(char heard, SimulatedSensor &sensor, BuildingMotion::Time now)
{
    if (heard != '\x7E') {
        if (m_buffer.size() < mostBytes) {
            m_buffer.append(heard);
        }
        return {};
    }
    const QByteArray frame = withoutEscapes(std::exchange(m_buffer, {}));
    char sum = 0;
    for (const char c : frame) {
        sum = static_cast<char>(sum ^ c);
    }
    if (frame.size() < 4 || sum != 0 || byte(frame, 2) != sensor.address) {
        return {};
    }
    const QByteArray data = frame.mid(3, frame.size() - 4);
    switch (byte(frame, 0)) {
    case 0x9B: return answerMain(byte(frame, 1), data, sensor, now);
    case 0x9C: return answerAdditional(byte(frame, 1), data, sensor);
    default: return {};
    }
}

} // namespace gorizont::ind3
