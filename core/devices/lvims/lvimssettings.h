#pragma once

#include "core/devices/lvims/lvimsregisters.h"

#include <QList>
#include <QString>

/// Single settings within SET: manual 003, sections 2.4 and 2.5. An image is all of SET, settingsSize registers in the order of
/// their addresses; what the manual does not describe in it stays as the module has it. Pure.
namespace gorizont::lvims {

struct Setting
{
    enum class Kind : quint8 {
        Text, ///< UTF-8, at most two bytes a register; what does not fit is cut off at a whole character
        Host, ///< IPv4 address that a module may have
        NetworkMask, ///< ones, then zeros
        Gateway, ///< IPv4 address; 0.0.0.0: none
        ChannelMask, ///< bits 0…3
        Milliseconds, ///< 1…4000
        Real, ///< any number that a float holds
        MeasurementType, ///< 0…16
        Switch, ///< 0, 1
        Frequency, ///< Hz, in steps of 0.1
    };

    QString name; ///< `WF_ACQ_TIME`, `CH1.SENSOR_K`, `CH0.MEAS3.TYPE`, `CH0.MEAS3.IIR_HP.EN`, `….FC`
    Kind kind = Kind::Text;
    quint16 address = 0; ///< within SET
    quint16 size = 1; ///< registers
    bool operator==(const Setting &) const = default;
};

constexpr int shortestWaveform = 1; ///< WF_ACQ_TIME, ms
constexpr int longestWaveform = 4000;
constexpr int lastMeasurementType = 16;
constexpr double highestCutOff = 429496729.5; ///< Hz: what the two registers hold

/// Those of the module, then those of channel 0 with its measurements, of channel 1, …
const QList<Setting> &allSettings();

/// nullptr: there is none of this name. Capital and small letters are one.
const Setting *settingNamed(const QString &name);
/// The names that changes of which cut the connection: IP_ADDR, IP_MASK, IP_GATE.
bool isOfNetwork(const Setting &setting);

/// As change() takes it: numbers with a point, frequencies in Hz.
QString valueOf(const QList<quint16> &image, const Setting &setting);

/// Puts \a text into \a image. Empty: done; else what \a setting takes, a sentence, and \a image is as before. Masks may be written
/// as 0x0F; a comma is a point.
QString change(QList<quint16> &image, const Setting &setting, const QString &text);

struct SettingDifference
{
    QString name; ///< of the setting; `SET+146…149`: registers that the manual does not describe
    QString before;
    QString after;
    bool isOfNetwork = false;
    bool operator==(const SettingDifference &) const = default;
};

/// In the order of allSettings(), what is not described last.
QList<SettingDifference> differences(const QList<quint16> &before, const QList<quint16> &after);

/// Registers of MUT_SETTINGS that are written at once.
struct SettingPiece
{
    quint16 offset = 0; ///< within SET
    QList<quint16> values; ///< at most as many as function 16 writes
    bool operator==(const SettingPiece &) const = default;
};

/// What makes an image \a wanted of the one that is \a there, ascending; a setting that differs is written whole.
QList<SettingPiece> piecesToWrite(const QList<quint16> &there, const QList<quint16> &wanted);

} // namespace gorizont::lvims
