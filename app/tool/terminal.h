#pragma once

#include <QString>

#include <functional>

namespace gorizont::tool {

/// Whether somebody sits there who can be asked.
bool isInputTerminal();
/// Whether somebody looks at stderr: only then it shows how far something has got.
bool isErrorTerminal();

/// Asks \a question on stderr, so that stdout stays for what was asked for. True: yes. The end of the input is no, and so is
/// what \a isInterrupted says.
bool askYesNo(const QString &question, const std::function<bool()> &isInterrupted);

/// Shows \a text in place of the last one; empty: clears it. Nothing where nobody looks.
void showProgress(const QString &text);

} // namespace gorizont::tool
