#pragma once

#include "app/tool/vimsoptions.h"
#include "core/line/line.h"

#include <QJsonObject>

namespace gorizont::tool {

/// One run of `gorizont-tool vims` on an open line: what it was told, and how it ends.
class VimsRun
{
public:
    VimsRun(const VimsOptions &options, Line &line)
        : m_options(options)
        , m_line(line)
    {
    }

    const VimsOptions &options() const { return m_options; }
    Line &line() const { return m_line; }

    QJsonObject object() const; ///< with what every one has
    /// Prints \a text, or \a found with --json.
    void tell(const QString &text, const QJsonObject &found) const;
    /// Says why it did not work. \a more: what is known beside the fault.
    ExitCode fail(Fault fault, const QString &sentence, const QJsonObject &more = {}) const;
    ExitCode fail(Fault fault) const;
    ExitCode usage(const QString &sentence) const; ///< the command line is at fault
    /// Whether the user agrees, or agreed before with --yes.
    bool isAgreed(const QString &question) const;

private:
    const VimsOptions &m_options;
    Line &m_line;
};

} // namespace gorizont::tool
