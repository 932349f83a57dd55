#include "core/devices/usmisn/usmisnsimulator.h"

#include <cmath>

namespace gorizont::usmisn {

namespace {

QByteArray padded(quint64 number, int width)
{
    return QByteArray::number(number).rightJustified(width, '0');
}

/// `-0002.48289`; a positive number has no sign.
QByteArray padded(double number, int digits, int decimals)
{
    const QByteArray text = QByteArray::number(std::abs(number), 'f', decimals);
    return (number < 0 ? "-" : "") + text.rightJustified(digits + 1 + decimals, '0');
}

} // namespace

QByteArray Simulator::reply(const Request &request, const QByteArray &data, const QByteArray &address) const
{
    const QByteArray from = address.isEmpty() ? request.addressText : address;
    return "\n%/R/" + from + '/' + request.transaction + '/' + request.command + '/' + data + "/%\r\n";
}

/// 0: none of its channels is meant. In a broadcast only the whole identifier counts.
int Simulator::channelNamed(const QByteArray &text, bool isToAll) const
{
    const quint64 number = text.toULongLong();
    const quint64 first = quint64(m_serial) * 100 + 1;
    if (number == first || number == first + 1) {
        return static_cast<int>(number - first) + 1;
    }
    return !isToAll && (number == 1 || number == 2) ? static_cast<int>(number) : 0;
}

QByteArray Simulator::fields(const SimulatedMemory::Record &record) const
{
    const QByteArray value = record.isOutOfRange ? "OutOfRange" : padded(record.value, 4, 5);
    return padded(quint64(record.timestamp), 11) + ',' + padded(quint64(m_serial) * 100 + quint64(record.channel), 11)
        + ',' + padded(quint64(record.count), 11) + ',' + value + ',' + padded(record.variation, 4, 5) + ','
        + padded(record.temperature, 2, 2) + ",A,Grad," + (record.channel == 1 ? "Angle_X" : "Angle_Y") + ",001,5";
}

QByteArray Simulator::identity(const Request &request) const
{
    const QByteArray &command = request.command;
    if (command == "GetAddress") {
        return reply(request, QByteArray::number(address()));
    }
    if (request.isToAll) {
        return {};
    }
    if (command == "GetSerial") {
        return reply(request, padded(m_serial, 8));
    }
    if (command == "GetType") {
        return reply(request, m_type);
    }
    if (command == "GetProgVersion") {
        return reply(request, "14.04.17");
    }
    if (command == "GetDateCalibration") {
        return reply(request, "00000042839");
    }
    if (command == "GetCountCalibration") {
        return reply(request, "00000000002");
    }
    if (command == "GetCRC") {
        return reply(request, padded(m_lastCrc, 10));
    }
    if (command != "GetInfo") {
        return {};
    }
    QByteArray x = reply(request, padded(quint64(m_serial) * 100 + 1, 10) + ",A,Grad,Angle_X");
    QByteArray y = reply(request, padded(quint64(m_serial) * 100 + 2, 10) + ",A,Grad,Angle_Y");
    x.replace("/%\r", "%\r"); // as the manual prints it
    y.replace("/%\r", "%\r");
    return x + y + reply(request, "End");
}

QByteArray Simulator::setting(const Request &request, Time now)
{
    QByteArray answer;
    if (request.command == "SetAddress") {
        bool isNumber = false;
        const int wanted = request.data.toInt(&isNumber);
        const bool isGood = isNumber && wanted >= 1 && wanted <= 255;
        answer = reply(request, isGood ? request.data : "ErrorData");
        setAddress(isGood ? wanted : address());
    } else if (request.command == "SetPortSettings") {
        answer = setPort(request);
    } else if (request.command == "ResetPortSettings") {
        answer = reply(request, {});
        m_ownPort = PortSettings();
    } else if (request.command == "StartCycle") {
        answer = startCycle(request, now);
    } else if (request.command == "StopCycle") {
        answer = reply(request, {});
        m_recorder.reset();
        m_bootedAt = now - std::chrono::seconds(10); // awake already, at its own port
    }
    return request.isToAll ? QByteArray() : answer;
}

QByteArray Simulator::setPort(const Request &request)
{
    const QByteArrayList parts = request.data.split(',');
    const int baud = parts.first().toInt();
    const qsizetype parity = parts.size() == 3 ? QByteArrayList{"N", "E", "O"}.indexOf(parts.at(1)) : -1;
    const qsizetype stop = parts.size() == 3 ? QByteArrayList{"1", "1_5", "2"}.indexOf(parts.at(2)) : -1;
    if (baud < 110 || baud > 115200 || parity < 0 || stop < 0) {
        return reply(request, "ErrorData");
    }
    m_ownPort = {baud, static_cast<Parity>(parity), static_cast<StopBits>(stop)};
    return reply(request, request.data);
}

QByteArray Simulator::startCycle(const Request &request, Time now)
{
    const QByteArrayList parts = request.data.split(',');
    const qint64 period = parts.size() == 4 ? parts.at(2).toLongLong() : 0;
    const qint64 delay = parts.size() == 4 ? parts.at(3).toLongLong() : -1;
    if (period < 900 || period > 43200 || delay < 0 || delay > 600) {
        return reply(request, "ErrorData");
    }
    m_recorder = Recorder{now, parts.at(0).toLongLong(), parts.at(1).toLongLong(), period, delay, 0};
    return reply(request, request.data);
}

} // namespace gorizont::usmisn
