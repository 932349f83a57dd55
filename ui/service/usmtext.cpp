#include "ui/service/usmtext.h"

#include "ui/models/valuetext.h"
#include "ui/service/servicetext.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>

namespace gorizont::usmtext {

namespace {

using usmisn::PortChange;
using usmisn::Value;
using usmisn::ValueState;

constexpr quint32 largestSerial = 99'999'999;

class UsmText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::UsmText)
};

QString parityOf(const PortSettings &port)
{
    return port.parity == Parity::Even ? QStringLiteral("E")
        : port.parity == Parity::Odd   ? QStringLiteral("O")
                                       : QStringLiteral("N");
}

QString stopBitsOf(const PortSettings &port)
{
    constexpr std::array<const char *, 3> texts{"1", "1.5", "2"};
    return QLatin1String(texts.at(static_cast<std::size_t>(port.stopBits)));
}

} // namespace

QString serial(quint32 serial)
{
    return QString::number(serial).rightJustified(8, u'0');
}

QString date(QDate date)
{
    return date.toString(QStringLiteral("dd.MM.yyyy"));
}

QString port(const PortSettings &port)
{
    return QStringLiteral("%1-%2-%3").arg(port.baudRate).arg(parityOf(port), stopBitsOf(port));
}

QString time(qint64 timestamp)
{
    return valuetext::clock(UtcTime(std::chrono::seconds(timestamp)));
}

QString value(const Result<Value> &value)
{
    if (!value) {
        return servicetext::fault(value.fault());
    }
    const QString temperature = valuetext::fixed(value->temperature, 2);
    switch (value->state) {
    case ValueState::Measured:
        return QStringLiteral("%1° ± %2°, %3 °C")
            .arg(valuetext::signedFixed(value->value, 5), valuetext::fixed(value->variation, 5), temperature);
    case ValueState::OutOfRange: return UsmText::tr("out of the range of measurement, %1 °C").arg(temperature);
    case ValueState::ErrorSensor:
        return UsmText::tr("the device cannot measure; its transducer may be broken (ErrorSensor)");
    case ValueState::ErrorChannel: return UsmText::tr("the device has no such channel (ErrorCH)");
    case ValueState::ErrorData: break;
    }
    return UsmText::tr("the device does not understand the request (ErrorData)");
}

QList<quint32> serials(const QString &text)
{
    static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
    QList<quint32> list;
    for (const QString &part : text.split(between, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const quint32 serial = part.toUInt(&isNumber);
        if (!isNumber || serial == 0 || serial > largestSerial) {
            return {};
        }
        list.append(serial);
    }
    return list;
}

QString place(quint32 serial, const Result<int> &found)
{
    const QString device = usmtext::serial(serial);
    if (!found) {
        return QStringLiteral("%1: %2").arg(device, servicetext::fault(found.fault()));
    }
    return *found == usmisn::everybody
        ? UsmText::tr("%1: it is there, but does not tell its address; scan the addresses").arg(device)
        : UsmText::tr("%1: address %2").arg(device).arg(*found);
}

QString addressOutcome(int from, int to, const Result<void> &changed)
{
    if (changed) {
        return UsmText::tr("new address %1, written").arg(to);
    }
    switch (changed.fault()) {
    case Fault::Refused:
        return UsmText::tr("new address %1, not written: it is taken, or the device will not. Scan again.").arg(to);
    case Fault::BadReply:
        return UsmText::tr("new address %1, not written: the device still answers at %2.").arg(to).arg(from);
    default: break;
    }
    return UsmText::tr("new address %1, %2: whether it was written is not known. Scan the line to find the device.")
        .arg(to)
        .arg(servicetext::fault(changed.fault()));
}

QString portOutcome(const PortChange &change, const PortSettings &wanted)
{
    const QString to = port(wanted);
    if (change.result) {
        return change.isProbed
            ? UsmText::tr("it answers at its new port settings %1").arg(to)
            : UsmText::tr("it has taken the new port settings %1; this line cannot be switched over to try them")
                  .arg(to);
    }
    switch (change.result.fault()) {
    case Fault::Refused: return UsmText::tr("it refuses the port settings %1; nothing was changed").arg(to);
    case Fault::BadReply: return UsmText::tr("it still answers at the old port settings, not at %1").arg(to);
    case Fault::Timeout:
        return UsmText::tr("it answers neither at the old port settings nor at %1. Switch it off and on: for its first "
                           "second it listens at 9600-N-1")
            .arg(to);
    default: break;
    }
    return UsmText::tr("what became of the port settings %1 is not known (%2)")
        .arg(to, servicetext::fault(change.result.fault()));
}

QString portReminder(const PortSettings &wanted, int portIndex)
{
    return UsmText::tr(
               "Write BaudRate=%1, Parity=%2, StopBits=%3 into [Port%4] of the configuration file and start the "
               "program again: until then it does not hear the device.")
        .arg(wanted.baudRate)
        .arg(parityOf(wanted), stopBitsOf(wanted))
        .arg(portIndex);
}

QString startOutcome(const Result<void> &started)
{
    if (started) {
        return UsmText::tr("it records and sleeps; polling gets no answer until it is woken");
    }
    switch (started.fault()) {
    case Fault::Refused: return UsmText::tr("it refuses to record; nothing was changed");
    case Fault::Timeout: return UsmText::tr("it does not answer; it may sleep already");
    default: break;
    }
    return UsmText::tr("whether it records is not known (%1)").arg(servicetext::fault(started.fault()));
}

} // namespace gorizont::usmtext
