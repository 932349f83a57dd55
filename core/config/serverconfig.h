#pragma once

#include "core/config/archivesettings.h"
#include "core/config/feedsettings.h"
#include "core/values/displacement.h"
#include "core/values/lineconfig.h"
#include "core/values/timing.h"

#include <QHash>
#include <QList>
#include <QString>

namespace gorizont {

class IniFile;

/// How the register blocks of units 3 and 6 are laid out (spec/gorizont.md, section 6).
enum class ModbusPacking : quint8 { ByType, ByNumber };

/// Which axis of the accelerometer ADC24 TCP serves.
enum class Adc24Axis : quint8 { X, Y };

/// Something in the ini that is not as it should be. Never fatal.
struct Complaint
{
    QString section; ///< as written in the file; empty: about the whole file
    QString key; ///< as written in the file; empty: about the whole section
    int line = 0; ///< 1…; 0: about something that is not in the file
    QString problem; ///< one sentence: what is wrong
    QString action; ///< one sentence: what was done

    QString text() const; ///< all of it in one line for the journal and the dialog
    bool operator==(const Complaint &) const = default;
};

/// GorizontServer.ini as structs (manual 000, section 5; spec/gorizont.md, section 1). Defaults are those of absent
/// keys.
struct ServerConfig
{
    QString caption = QStringLiteral("Gorizont Server"); ///< Caption: title of the window
    QString name; ///< Name: comment on this copy
    QString serialNumber; ///< SerialNumber: kept, without effect
    QString language; ///< Language: `ru`, `en`; empty: ru
    int modbusPort = 502; ///< IPPort1
    int adc24Port = 503; ///< IPPort2
    bool servesModbus = true; ///< CanModbus
    bool servesAdc24 = true; ///< CanADC24
    bool servesOpc = false; ///< CanOPCDA
    bool showsAdvanced = false; ///< ShowAdvanced
    bool allowsCopy = false; ///< CanCopy
    bool startsHidden = false; ///< CanHide
    bool closesSilently = true; ///< CanClose=1: no warning at the end
    bool savesFiles = true; ///< CanSave
    bool asksInformation = false; ///< CanInfo
    int memoCount = 60; ///< MemoCount: lines on the measurements tab
    int memoDelete = 1; ///< MemoDel: lines removed when it is full
    int ringPackets = 8192; ///< SrsBufSize, packets of 32 samples
    int packetsToSave = 1; ///< SrsBufToSave: a binary file holds SrsBufSize × 32 × SrsBufToSave samples
    double gravity = 9.81347; ///< Gravity, m/s²

    ModbusPacking modbusPacking = ModbusPacking::ByType;
    int modbusBase = 0; ///< 0 or 1: the register where the blocks of units 3 and 6 start
    int modbusClients = 64; ///< ModbusClients: connections at a time, 1…
    std::chrono::seconds modbusIdle{600}; ///< ModbusIdle: a silent client is cut off after this; 0: never
    QString modbusBind; ///< ModbusBind: address to listen on; empty: all
    QStringList modbusAllow; ///< ModbusAllow: addresses and CIDR blocks; empty: everybody
    bool hasLegacyStatusBits = false; ///< LegacyStatusBits
    int adc24Sensor = 0; ///< [ADC24] Sensor: N of an accelerometer; 0: the first
    Adc24Axis adc24Axis = Adc24Axis::X; ///< [ADC24] Axis

    ArchiveSettings archive;
    MqttSettings mqtt;
    MetricsSettings metrics;
    OpcSettings opc;
    Timing timing;
    QList<ChainConfig> chains; ///< in ascending index; what cannot be used is left out
    QList<LineConfig> lines; ///< in the order of the sections; what is off is listed too

    /// Values that the file gave and the program could not use, for <Настройки>: `section/key`, lower case → as
    /// written.
    QHash<QString, QString> replaced;

    bool operator==(const ServerConfig &) const = default;
};

struct ConfigReading
{
    ServerConfig config;
    QList<Complaint> complaints;
};

/// Pure: every mistake becomes a complaint and a default, the result is always usable.
ConfigReading readServerConfig(const IniFile &file);

} // namespace gorizont
