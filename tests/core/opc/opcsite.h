#pragma once

#include "core/config/inifile.h"
#include "core/config/serverconfig.h"

namespace gorizont::test {

/// The site of manual 000, 11.5: АН-Д3 on COM5, ИН-Д3 on COM16; \a more: lines of the ini behind them.
inline ServerConfig opcSite(const QByteArray &more = {})
{
    return readServerConfig(IniFile::fromBytes(
                                "[Common]\nCanOPCDA=1\nNumOfPorts=3\n"
                                "[Port1]\nNum=5\nOn=1\nNumOfSensors=1\nName1=AN-D3\nadr1=2\nN1=1\nOn1=1\n"
                                "[Port2]\nNum=16\nOn=1\nNumOfSensors=1\nName1=IN-D3\nadr1=3\nN1=2\nOn1=1\n"
                                + (more.isEmpty() ? QByteArray("[Port3]\nNum=1\nOn=0\nNumOfSensors=0\n") : more)))
        .config;
}

} // namespace gorizont::test
