#include "core/config/sectionreader.h"

#include <QCoreApplication>

#include <cmath>

namespace gorizont {

namespace {

/// No title, name or remark is longer; a window system is not asked to show megabytes.
constexpr qsizetype longestText = 4000; ///< characters

/// A number as the file gives it, or why it is none that can be used.
struct Number
{
    double value = 0;
    QString problem; ///< empty: the value is good
};

QString outside(const QString &written, double value, SectionReader::Range range)
{
    if (range.maximum >= std::numeric_limits<int>::max()) {
        return value < range.minimum ? QCoreApplication::translate("ServerConfig", "%1 is less than %2.")
                                           .arg(quoted(written), QString::number(range.minimum))
                                     : QCoreApplication::translate("ServerConfig", "%1 is more than %2.")
                                           .arg(quoted(written), QString::number(range.maximum, 'f', 0));
    }
    return QCoreApplication::translate("ServerConfig", "%1 is outside %2…%3.")
        .arg(quoted(written), QString::number(range.minimum), QString::number(range.maximum, 'g', 10));
}

Number inRange(const QString &written, double value, SectionReader::Range range)
{
    if (value < range.minimum || value > range.maximum) {
        return {0, outside(written, value, range)};
    }
    return {value, {}};
}

Number wholeNumber(const QString &written, SectionReader::Range range)
{
    bool isNumber = false;
    const qlonglong value = written.toLongLong(&isNumber);
    if (!isNumber) {
        return {0, QCoreApplication::translate("ServerConfig", "%1 is not a whole number.").arg(quoted(written))};
    }
    return inRange(written, static_cast<double>(value), range);
}

/// The decimal mark may be a point or a comma (spec/gorizont.md, section 1).
Number realNumber(const QString &written, SectionReader::Range range)
{
    bool isNumber = false;
    const double value = QString(written).replace(u',', u'.').toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value)) {
        return {0, QCoreApplication::translate("ServerConfig", "%1 is not a number.").arg(quoted(written))};
    }
    return inRange(written, value, range);
}

} // namespace

SectionReader::SectionReader(const IniFile &file, const QString &section, Findings &findings, const QString &suffix)
    : m_file(file)
    , m_section(section)
    , m_suffix(suffix)
    , m_findings(findings)
{
}

void SectionReader::take(const QString &key, QString &value)
{
    const auto entry = find(key);
    if (!entry) {
        return;
    }
    value = entry->value.left(longestText);
    if (value.size() < entry->value.size()) {
        refuse(
            key, *entry,
            QCoreApplication::translate("ServerConfig", "The text is longer than %1 characters.").arg(longestText),
            QCoreApplication::translate("ServerConfig", "Its beginning is used."));
    }
}

void SectionReader::take(const QString &key, bool &value)
{
    take<bool>(key, value, {{QStringLiteral("0"), false}, {QStringLiteral("1"), true}});
}

bool SectionReader::take(const QString &key, int &value, Range range, const QString &action)
{
    const auto entry = find(key);
    if (!entry) {
        return true;
    }
    const Number number = wholeNumber(entry->value, range);
    if (number.problem.isEmpty()) {
        value = static_cast<int>(number.value);
        return true;
    }
    refuse(key, *entry, number.problem, action.isEmpty() ? defaultIsUsed(QString::number(value)) : action);
    return false;
}

bool SectionReader::take(const QString &key, double &value, Range range, const QString &action)
{
    const auto entry = find(key);
    if (!entry) {
        return true;
    }
    const Number number = realNumber(entry->value, range);
    if (!number.problem.isEmpty()) {
        refuse(key, *entry, number.problem, action.isEmpty() ? defaultIsUsed(QString::number(value)) : action);
        return false;
    }
    value = number.value;
    return true;
}

void SectionReader::take(const QString &key, std::chrono::milliseconds &value, Range range)
{
    takeDuration(key, value, range);
}

void SectionReader::take(const QString &key, std::chrono::seconds &value, Range range)
{
    takeDuration(key, value, range);
}

template <typename Duration> void SectionReader::takeDuration(const QString &key, Duration &value, Range range)
{
    int count = static_cast<int>(value.count());
    take(key, count, range);
    value = Duration(count);
}

void SectionReader::complain(const QString &key, const QString &problem, const QString &action)
{
    const auto entry = find(key);
    m_findings.add(
        {m_section, entry ? entry->key : QString(), entry ? entry->line : m_file.sectionLine(m_section), problem,
         action});
}

void SectionReader::replace(const QString &key)
{
    if (const auto entry = find(key)) {
        m_findings.addReplaced(m_section, key + m_suffix, entry->value);
    }
}

void SectionReader::refuse(
    const QString &key, const IniFile::Entry &entry, const QString &problem, const QString &action)
{
    const bool isEmpty = entry.value.isEmpty();
    m_findings.add(
        {entry.section, entry.key, entry.line,
         isEmpty ? QCoreApplication::translate("ServerConfig", "There is no value.") : problem, action});
    m_findings.addReplaced(m_section, key + m_suffix, entry.value);
}

QString SectionReader::noneOf(const IniFile::Entry &entry, const QStringList &names)
{
    return QCoreApplication::translate("ServerConfig", "%1 is none of %2.")
        .arg(quoted(entry.value), names.join(QStringLiteral(", ")));
}

QString SectionReader::defaultIsUsed(const QString &value)
{
    return QCoreApplication::translate("ServerConfig", "The default %1 is used.").arg(value);
}

} // namespace gorizont
