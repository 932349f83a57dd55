#pragma once

#include <QString>

namespace gorizont::tool {

/// Whether somebody sits there who can be asked.
bool isInputTerminal();
/// Whether somebody looks at stderr: only then it shows how far something has got.
bool isErrorTerminal();

/// Asks \a question on stderr, so that stdout stays for what was asked for. True: yes. Ctrl+C and the end of the input are no.
bool askYesNo(const QString &question);

/// Shows \a text in place of the last one; empty: clears it. Nothing where nobody looks.
void showProgress(const QString &text);

} // namespace gorizont::tool
