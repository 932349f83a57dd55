#include "app/tool/vimssettings.h"

#include "app/tool/text.h"
#include "app/tool/vimstext.h"
#include "core/files/wholefile.h"

#include <QFile>
#include <QJsonArray>

#include <algorithm>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

using namespace lvims;

namespace {

QStringList linesOf(const QList<SettingDifference> &differences)
{
    QStringList lines;
    for (const SettingDifference &difference : differences) {
        lines.append(u"%1: %2 → %3"_s.arg(difference.name, difference.before, difference.after));
    }
    return lines;
}

QJsonArray arrayOf(const QList<SettingDifference> &differences, const QString &before, const QString &after)
{
    QJsonArray array;
    for (const SettingDifference &difference : differences) {
        array.append(QJsonObject{{u"name"_s, difference.name}, {before, difference.before}, {after, difference.after}});
    }
    return array;
}

bool touchesNetwork(const QList<SettingDifference> &differences)
{
    return std::any_of(differences.begin(), differences.end(), [](const SettingDifference &difference) {
        return difference.isOfNetwork;
    });
}

QString nothingWritten()
{
    return Text::tr("nothing was written. --yes writes without asking");
}

} // namespace

VimsSettings::VimsSettings(const VimsRun &run)
    : m_run(run)
    , m_service(run.options().address, run.options().timing)
{
}

QJsonObject VimsSettings::outcome(const QString &setting, bool isDone) const
{
    return {{u"setting"_s, setting}, {u"done"_s, isDone}};
}

void VimsSettings::tell(const QString &text, const QJsonObject &outcome) const
{
    QJsonObject found = m_run.object();
    for (auto it = outcome.constBegin(); it != outcome.constEnd(); ++it) {
        found.insert(it.key(), it.value());
    }
    m_run.tell(text, found);
}

/// The errors of the module are told with it.
ExitCode VimsSettings::fail(Fault fault, QJsonObject outcome) const
{
    outcome.insert(u"done"_s, false);
    insertErrors(outcome, m_errors);
    return m_run.fail(fault, textOf(m_errors, fault), outcome);
}

ExitCode VimsSettings::settings()
{
    const VimsOptions &options = m_run.options();
    if (options.shows) {
        return show();
    }
    if (!options.saveTo.isEmpty()) {
        return save();
    }
    return options.loadFrom.isEmpty() ? edit() : load();
}

ExitCode VimsSettings::show()
{
    const auto current = m_service.settings(m_run.line(), moduleRegister("CUR_SETTINGS"));
    const auto prepared = current ? m_service.settings(m_run.line(), moduleRegister("MUT_SETTINGS")) : current;
    if (!prepared) {
        return m_run.fail(prepared.fault());
    }
    const auto differing = differences(current->values(), prepared->values());
    QJsonObject values;
    QStringList lines;
    for (const Setting &setting : allSettings()) {
        const QString value = valueOf(current->values(), setting);
        values.insert(setting.name, value);
        lines.append(u"%1 = %2"_s.arg(setting.name, value));
    }
    if (!differing.isEmpty()) {
        lines.append(Text::tr("Prepared and not in use (value in use → value prepared):"));
        lines.append(linesOf(differing));
    }
    QJsonObject found = outcome(u"settings"_s, true);
    found.insert(u"values"_s, values);
    found.insert(u"differences"_s, arrayOf(differing, u"current"_s, u"changed"_s));
    tell(lines.join(u'\n'), found);
    return ExitGood;
}

ExitCode VimsSettings::save()
{
    const auto identity = m_service.identity(m_run.line());
    if (!identity) {
        return m_run.fail(identity.fault());
    }
    const auto set = m_service.settings(m_run.line(), moduleRegister("CUR_SETTINGS"));
    if (!set) {
        return m_run.fail(set.fault());
    }
    const QString &path = m_run.options().saveTo;
    if (const QString problem = writeWholeFile(path, settingsFile(*identity, set->values())); !problem.isEmpty()) {
        return m_run.fail(Fault::Refused, problem);
    }
    QJsonObject found = outcome(u"settings"_s, true);
    found.insert(u"file"_s, path);
    tell(Text::tr("The settings are in %1.").arg(path), found);
    return ExitGood;
}

ExitCode VimsSettings::load()
{
    const QString &path = m_run.options().loadFrom;
    QFile file(path);
    const auto values = file.open(QIODevice::ReadOnly) ? settingsIn(file.readAll()) : std::nullopt;
    if (!values) {
        return m_run.usage(Text::tr("%1 is no file of settings").arg(path));
    }
    if (!m_run.isAgreed(Text::tr("All settings of the module change, its network address too. Write them?"))) {
        return m_run.fail(Fault::Cancelled, nothingWritten());
    }
    const auto done = m_service.restoreSettings(m_run.line(), *values, m_run.options().toFlash);
    m_errors = m_service.errors();
    QJsonObject found = outcome(u"settings"_s, bool(done));
    found.insert(u"file"_s, path);
    if (!done) {
        return fail(done.fault(), found);
    }
    insertErrors(found, m_errors);
    tell(Text::tr("The module uses the settings of %1.").arg(path), found);
    return ExitGood;
}

/// What was prepared before, by whomever, stays prepared; the question names all that will change.
ExitCode VimsSettings::edit()
{
    const VimsOptions &options = m_run.options();
    const auto current = m_service.settings(m_run.line(), moduleRegister("CUR_SETTINGS"));
    const auto prepared = current ? m_service.settings(m_run.line(), moduleRegister("MUT_SETTINGS")) : current;
    if (!prepared) {
        return m_run.fail(prepared.fault());
    }
    QList<quint16> wanted = prepared->values();
    for (const auto &[setting, value] : options.changes) {
        if (const QString problem = change(wanted, setting, value); !problem.isEmpty()) {
            return m_run.fail(Fault::Refused, problem);
        }
    }
    const auto changes = differences(options.applies ? current->values() : prepared->values(), wanted);
    QStringList question = linesOf(changes);
    const bool cutsOff = options.applies && touchesNetwork(changes);
    if (cutsOff) {
        question.append(Text::tr("The network address of the module changes: this connection will be lost."));
    }
    if (options.toFlash) {
        question.append(Text::tr("The module keeps its prepared settings for its next start."));
    }
    question.append(Text::tr("Write them?"));
    if (!m_run.isAgreed(question.join(u'\n'))) {
        return m_run.fail(Fault::Cancelled, nothingWritten());
    }
    QJsonObject found = outcome(u"settings"_s, true);
    found.insert(u"changes"_s, arrayOf(changes, u"before"_s, u"after"_s));
    found.insert(u"applied"_s, options.applies);
    found.insert(u"flash"_s, options.toFlash);
    if (const auto done = write(prepared->values(), wanted, cutsOff); !done) {
        return fail(done.fault(), found);
    }
    insertErrors(found, m_errors);
    tell(linesOf(changes).join(u'\n') + (changes.isEmpty() ? QString() : u"\n"_s) + Text::tr("Done."), found);
    return ExitGood;
}

/// To flash before they are used: with another network address nobody would hear the second command.
Result<void> VimsSettings::write(const QList<quint16> &prepared, const QList<quint16> &wanted, bool cutsOff)
{
    Line &line = m_run.line();
    Result<void> done;
    for (const SettingPiece &piece : piecesToWrite(prepared, wanted)) {
        done = done ? m_service.write(line, piece) : done;
    }
    done = checked(done, false);
    if (done && m_run.options().toFlash) {
        done = checked(m_service.saveToFlash(line));
    }
    if (!done || !m_run.options().applies) {
        return done;
    }
    const auto applied = m_service.apply(line);
    const bool isGone = !applied && cutsOff && (applied.fault() == Fault::Timeout || applied.fault() == Fault::Closed);
    return cutsOff && (applied || isGone) ? Result<void>() : checked(applied);
}

/// What the module thinks of what was written, or of the \a command; of settings that were only written it thinks nothing yet.
Result<void> VimsSettings::checked(const Result<void> &written, bool isCommand)
{
    const auto errors = m_service.readErrors(m_run.line());
    if (!errors) {
        return written ? Result<void>(errors.fault()) : written;
    }
    m_errors = *errors;
    const bool isRefused = m_errors.first != 0 || (isCommand && m_errors.second != 0);
    return written && isRefused ? Result<void>(Fault::Refused) : written;
}

ExitCode VimsSettings::reload()
{
    const QString question =
        Text::tr("The module uses the settings of its flash from now on; what was only applied is lost. Go on?");
    if (!m_run.isAgreed(question)) {
        return m_run.fail(Fault::Cancelled, nothingWritten());
    }
    QJsonObject found = outcome(u"reload"_s, true);
    if (const auto done = checked(m_service.loadFromFlash(m_run.line())); !done) {
        return fail(done.fault(), found);
    }
    insertErrors(found, m_errors);
    tell(Text::tr("The module uses the settings of its flash."), found);
    return ExitGood;
}

ExitCode VimsSettings::reboot()
{
    if (!m_run.isAgreed(Text::tr("The module restarts; it measures nothing and switches no relay meanwhile. Go on?"))) {
        return m_run.fail(Fault::Cancelled, nothingWritten());
    }
    if (const auto done = m_service.restart(m_run.line()); !done) {
        return m_run.fail(done.fault());
    }
    tell(Text::tr("The module restarts."), outcome(u"reboot"_s, true));
    return ExitGood;
}

} // namespace gorizont::tool
