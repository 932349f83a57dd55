#pragma once

#include "core/devices/usmisn/usmisnvalues.h"

#include <QStringList>

class QCommandLineParser;

namespace gorizont::tool {

/// What only the commands of УСМ-ИСН take.
struct UsmOptions
{
    int channel = 0; ///< 0: both
    bool isStored = false;
    usmisn::RecordMask mask = usmisn::RecordMask::All;
    int count = 0; ///< of the last records; 0: all
    QString csvFile; ///< of records; empty: none
    std::chrono::seconds startIn{10};
    std::chrono::seconds period{3600};
    std::chrono::seconds delay{0};
    int newAddress = 0;
    PortSettings port;
    quint32 serial = 0; ///< of find
};

/// Reads them for the command \a name. What is wrong, as a sentence; empty: nothing.
QString readUsmOptions(
    const QCommandLineParser &parser, const QString &name, const QStringList &arguments, UsmOptions &options);

} // namespace gorizont::tool
