#include "core/config/inifile.h"
#include "core/config/serverconfig.h"

#include <cstdint>
#include <cstdlib>

/// Any bytes come back as they were, and any bytes make a configuration with at most 201 complaints.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    gorizont::IniFile file = gorizont::IniFile::fromBytes(bytes);
    const gorizont::ConfigReading reading = gorizont::readServerConfig(file);
    if (file.toBytes() != bytes || reading.complaints.size() > 201 || reading.config.lines.size() > 16) {
        std::abort();
    }
    file.setValue(QStringLiteral("Common"), QStringLiteral("Name"), QStringLiteral("x"));
    const auto entry =
        gorizont::IniFile::fromBytes(file.toBytes()).find(QStringLiteral("common"), QStringLiteral("name"));
    if (!entry || entry->value != QStringLiteral("x")) {
        std::abort();
    }
    return 0;
}
