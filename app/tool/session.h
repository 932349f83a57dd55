#pragma once

#include "app/tool/options.h"
#include "core/line/line.h"

#include <QJsonObject>

namespace gorizont::tool {

/// One run of a command on an open line: what it was told, and how it ends.
class Session
{
public:
    Session(const Options &options, Line &line)
        : m_options(options)
        , m_line(line)
    {
    }

    const Options &options() const { return m_options; }
    Line &line() const { return m_line; }

    /// A JSON object that begins with what every one has.
    QJsonObject object(int address) const;

    /// What became of a \a setting of the sensor with --address.
    QJsonObject outcome(const QString &setting, bool isDone) const;

    /// Prints \a text, or \a object with --json.
    void tell(const QString &text, const QJsonObject &object) const;

    /// Says why it did not work, on stderr and with --json on stdout too. \a object: what is known beside the fault.
    ExitCode fail(Fault fault, const QString &sentence, QJsonObject object) const;
    ExitCode fail(Fault fault, int address) const;

    /// Whether the user agrees, or agreed before with --yes.
    bool isAgreed(const QString &question) const;

    /// Waits; false: Ctrl+C.
    bool wait(std::chrono::milliseconds time) const;

private:
    const Options &m_options;
    Line &m_line;
};

ExitCode exitCodeOf(Fault fault);

/// A word or two for the user.
QString faultText(Fault fault);

} // namespace gorizont::tool
