#include "app/tool/usmtext.h"

#include "app/tool/output.h"
#include "app/tool/text.h"

#include <QDateTime>
#include <QJsonArray>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using usmisn::Value;
using usmisn::ValueState;

QString isoTime(qint64 timestamp)
{
    return QDateTime::fromSecsSinceEpoch(timestamp, Qt::UTC).toString(Qt::ISODate);
}

QString axisOf(const Value &value)
{
    return value.channel.channel() == usmisn::channelX ? u"X"_s : u"Y"_s;
}

QString stateKey(ValueState state)
{
    switch (state) {
    case ValueState::Measured: return u"measured"_s;
    case ValueState::OutOfRange: return u"out of range"_s;
    case ValueState::ErrorSensor: return u"sensor error"_s;
    case ValueState::ErrorChannel: return u"no such channel"_s;
    case ValueState::ErrorData: break;
    }
    return u"not understood"_s;
}

} // namespace

QString serialText(quint32 serial)
{
    return QString::number(serial).rightJustified(8, u'0');
}

void insertIdentity(QJsonObject &object, const usmisn::Identity &identity)
{
    object.insert(u"deviceType"_s, identity.type);
    object.insert(u"serial"_s, qint64(identity.serial));
    if (!identity.isInclinometer()) {
        return insertNulls(object, {u"program"_s, u"calibratedOn"_s, u"calibrations"_s, u"channels"_s});
    }
    QJsonArray channels;
    for (const usmisn::Channel &channel : identity.channels) {
        channels.append(QJsonObject{
            {u"id"_s, qint64(channel.id.value)},
            {u"type"_s, channel.type},
            {u"units"_s, channel.units},
            {u"description"_s, channel.description}});
    }
    object.insert(u"program"_s, identity.program.toString(Qt::ISODate));
    object.insert(u"calibratedOn"_s, identity.calibratedOn.toString(Qt::ISODate));
    object.insert(u"calibrations"_s, qint64(identity.calibrations));
    object.insert(u"channels"_s, channels);
}

void insertValue(QJsonObject &object, const Value &value)
{
    object.insert(u"state"_s, stateKey(value.state));
    insertNulls(
        object,
        {u"time"_s, u"timestamp"_s, u"serial"_s, u"channel"_s, u"measurement"_s, u"value"_s, u"variation"_s,
         u"temperature"_s});
    if (value.state != ValueState::Measured && value.state != ValueState::OutOfRange) {
        return;
    }
    object.insert(u"serial"_s, qint64(value.channel.serial()));
    object.insert(u"channel"_s, value.channel.channel());
    object.insert(u"temperature"_s, value.temperature);
    if (value.timestamp != 0) {
        object.insert(u"time"_s, isoTime(value.timestamp));
        object.insert(u"timestamp"_s, value.timestamp);
        object.insert(u"measurement"_s, qint64(value.measurement));
    }
    if (value.state == ValueState::Measured) {
        object.insert(u"value"_s, value.value);
        object.insert(u"variation"_s, value.variation);
    }
}

QString lineOf(const Value &value)
{
    const QString when =
        value.timestamp == 0 ? QString() : u"%1  № %2  "_s.arg(isoTime(value.timestamp)).arg(value.measurement);
    const QString temperature = Text::tr("temperature %1 °C").arg(fixed(value.temperature, 2));
    switch (value.state) {
    case ValueState::Measured:
        return when
            + u"%1 %2  %3°  ±%4°  %5"_s.arg(serialText(value.channel.serial()))
                  .arg(axisOf(value))
                  .arg(fixed(value.value, 5), fixed(value.variation, 5), temperature);
    case ValueState::OutOfRange:
        return when
            + u"%1 %2  %3  %4"_s.arg(serialText(value.channel.serial()))
                  .arg(axisOf(value))
                  .arg(Text::tr("out of range"), temperature);
    case ValueState::ErrorSensor: return Text::tr("the device cannot measure; its transducer may be broken");
    case ValueState::ErrorChannel:
    case ValueState::ErrorData: break;
    }
    return none;
}

QString lineOf(const usmisn::Identity &identity)
{
    const QString start = u"%1  "_s.arg(identity.address, 3);
    if (!identity.isInclinometer()) {
        return start
            + Text::tr("serial number %1, not an УСМ-ИСН (type %2)")
                  .arg(serialText(identity.serial))
                  .arg(identity.type);
    }
    return start
        + Text::tr("serial number %1, calibrated on %2")
              .arg(serialText(identity.serial), identity.calibratedOn.toString(u"dd.MM.yyyy"_s));
}

QString textOf(const usmisn::Identity &identity)
{
    QStringList lines{
        Text::tr("address: %1").arg(identity.address), Text::tr("type: %1").arg(identity.type),
        Text::tr("serial number: %1").arg(serialText(identity.serial))};
    if (identity.isInclinometer()) {
        lines.append(Text::tr("program of: %1").arg(identity.program.toString(u"dd.MM.yyyy"_s)));
        lines.append(Text::tr("calibrated on: %1").arg(identity.calibratedOn.toString(u"dd.MM.yyyy"_s)));
        lines.append(Text::tr("calibrations: %1").arg(identity.calibrations));
    }
    for (const usmisn::Channel &channel : identity.channels) {
        lines.append(Text::tr("channel %1: %2, %3, %4")
                         .arg(channel.id.channel())
                         .arg(channel.id.value)
                         .arg(channel.description, channel.units));
    }
    return lines.join(u'\n');
}

} // namespace gorizont::tool
