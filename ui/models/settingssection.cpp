#include "ui/models/settingssection.h"

namespace gorizont {

SettingsSection::SettingsSection(
    const ServerConfig &config, Properties &list, const QString &title, const QString &iniSection)
    : m_config(config)
    , m_list(list)
    , m_section(iniSection)
{
    list += Property::section(title);
}

void SettingsSection::add(const QString &keys, const QString &name, const QString &value, const QString &note)
{
    Property property{name, value, note};
    for (const QString &key : keys.split(u'|', Qt::SkipEmptyParts)) {
        if (property.key.isEmpty()) {
            property.key = QStringLiteral("[%1] %2").arg(m_section, key);
        }
        const auto found = m_config.replaced.constFind((m_section + u'/' + key).toLower());
        if (found != m_config.replaced.cend()) {
            property.replaced =
                Settings::tr("the file gives “%1”, which cannot be used; “%2” is used").arg(*found, value);
        }
    }
    m_list += property;
}

void SettingsSection::addTime(const char *keys, std::chrono::milliseconds time, const QString &meaning)
{
    const QString name = QString::fromLatin1(keys).section(u'|', 0, 0);
    add(keys, name, Settings::tr("%1 ms").arg(time.count()), meaning);
}

void SettingsSection::addLimit(const char *key, int limit, const QString &meaning)
{
    add(key, QLatin1String(key), QString::number(limit), meaning);
}

} // namespace gorizont
