#pragma once

#include <QString>

namespace gorizont {

/// Switches all sentences of the program, and those of Qt where they are installed, to \a language (`ru`, `en`; empty:
/// `ru`). Call it in the main thread after the application exists and before anything is shown. False: there is no such
/// language, and the sentences stay in English.
bool installTranslation(const QString &language);

} // namespace gorizont
