#pragma once

#include "core/config/serverconfig.h"
#include "ui/models/property.h"

#include <QCoreApplication>

namespace gorizont {

/// The translation context of the tab <Настройки>.
struct Settings
{
    Q_DECLARE_TR_FUNCTIONS(Settings)
};

/// Gathers the entries of one section of the tab <Настройки> and looks up which of them the ini gave in vain.
class SettingsSection
{
public:
    /// \a iniSection: where the keys stand in the file, without brackets.
    SettingsSection(const ServerConfig &config, Properties &list, const QString &title, const QString &iniSection);

    /// \a keys: as in the ini, all spellings of it, separated by `|`; empty: the entry has none.
    void add(const QString &keys, const QString &name, const QString &value, const QString &note);
    void add(const char *keys, const QString &name, const QString &value, const QString &note)
    {
        add(QLatin1String(keys), name, value, note);
    }

    /// What follows stands in another section of the file.
    void readFrom(const QString &iniSection) { m_section = iniSection; }

    /// Entries that have no other name than their key.
    void addTime(const char *keys, std::chrono::milliseconds time, const QString &meaning);
    void addLimit(const char *key, int limit, const QString &meaning);

private:
    const ServerConfig &m_config;
    Properties &m_list;
    QString m_section;
};

} // namespace gorizont
