#pragma once

#include <QList>
#include <QStringList>

namespace gorizont::tool {

class Session;

/// Exit codes of gorizont-tool: a contract for scripts.
enum ExitCode {
    ExitGood = 0,
    ExitRefused = 1, ///< by the sensor, or by the user: no, Ctrl+C, no terminal to ask at
    ExitUsage = 2,
    ExitNoAnswer = 3, ///< from the sensor; or the port cannot be opened, or is lost
};

enum class Device : quint8 { Ind3, And3, Usm };

/// One thing that the tool can do: a row of the table, all that the command line and the help need to know.
struct Command
{
    using Run = ExitCode (*)(Session &session);

    QString name{};
    QString arguments{}; ///< as the help shows them, separated by blanks; each is needed
    QStringList options{}; ///< beside those that every command takes
    bool needsAddress = true;
    bool writes = false; ///< changes something in the sensor: asks before
    Run runInd3 = nullptr; ///< empty: this type does not have it
    Run runAnd3 = nullptr;
    Run runUsm = nullptr; ///< its name begins with `usm`, then there is no other type
    QString description{};

    Run runOf(Device device) const
    {
        return device == Device::Ind3 ? runInd3 : device == Device::And3 ? runAnd3 : runUsm;
    }
    qsizetype argumentCount() const { return arguments.split(u' ', Qt::SkipEmptyParts).size(); }
};

/// In the language that is installed when it is first called.
const QList<Command> &commands();

/// Empty: there is none.
const Command *commandNamed(const QString &name);

} // namespace gorizont::tool
