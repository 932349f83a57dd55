#pragma once

#include "core/config/findings.h"
#include "core/config/inifile.h"

#include <chrono>
#include <limits>

namespace gorizont {

/// Takes the keys of one section, or of one sensor in the section of a port, into the members of a struct. The member
/// holds the default: an absent key leaves it, a value that cannot be used leaves it and is complained about.
class SectionReader
{
public:
    struct Range
    {
        double minimum = 0;
        double maximum = std::numeric_limits<int>::max();
    };

    /// A name in the ini (any case) and what it stands for.
    template <typename T> using Choice = QPair<QString, T>;

    /// \a suffix is appended to every key: the index of a sensor within its port.
    SectionReader(const IniFile &file, const QString &section, Findings &findings, const QString &suffix = {});

    bool has(const QString &key) const { return find(key).has_value(); }

    void take(const QString &key, QString &value); ///< the beginning of what is longer than a text can be
    void take(const QString &key, bool &value); ///< 0 or 1
    void take(const QString &key, std::chrono::milliseconds &value, Range range);
    void take(const QString &key, std::chrono::seconds &value, Range range);
    /// False: the key is there and cannot be used. \a action says what is done then; empty: the default is used.
    bool take(const QString &key, int &value, Range range, const QString &action = {});
    /// As above.
    bool take(const QString &key, double &value, Range range, const QString &action = {});

    template <typename T> void take(const QString &key, T &value, const QList<Choice<T>> &choices)
    {
        const auto entry = find(key);
        if (!entry) {
            return;
        }
        QStringList names;
        QString usual;
        const QString written = QString(entry->value).replace(u',', u'.');
        for (const Choice<T> &choice : choices) {
            if (choice.first.compare(written, Qt::CaseInsensitive) == 0) {
                value = choice.second;
                return;
            }
            names.append(choice.first);
            usual = choice.second == value ? choice.first : usual;
        }
        refuse(key, *entry, noneOf(*entry, names), defaultIsUsed(usual));
    }

    /// Complains about \a key at its line, or at the line of the section where the key is not given.
    void complain(const QString &key, const QString &problem, const QString &action);
    /// The value of \a key is not the one that the program goes by.
    void replace(const QString &key);

    const QString &section() const { return m_section; }

private:
    std::optional<IniFile::Entry> find(const QString &key) const { return m_file.find(m_section, key + m_suffix); }
    void refuse(const QString &key, const IniFile::Entry &entry, const QString &problem, const QString &action);
    static QString noneOf(const IniFile::Entry &entry, const QStringList &names);
    static QString defaultIsUsed(const QString &value);
    template <typename Duration> void takeDuration(const QString &key, Duration &value, Range range);

    const IniFile &m_file;
    QString m_section; ///< as written
    QString m_suffix;
    Findings &m_findings;
};

} // namespace gorizont
