#include "app/tool/terminal.h"

#include <QStringList>

#include <array>
#include <cstdio>

#ifdef Q_OS_WIN
#include <io.h>
#else
#include <poll.h>
#include <unistd.h>
#endif

namespace gorizont::tool {

namespace {

bool isTerminal(std::FILE *file)
{
#ifdef Q_OS_WIN
    return _isatty(_fileno(file)) != 0;
#else
    return ::isatty(::fileno(file)) != 0;
#endif
}

/// False: \a isInterrupted said so first. Looked at in slices, because a signal may come just before the wait.
bool waitForInput([[maybe_unused]] const std::function<bool()> &isInterrupted)
{
#ifndef Q_OS_WIN
    constexpr int sliceMs = 100;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (::poll(&input, 1, sliceMs) <= 0) {
        if (isInterrupted()) {
            return false;
        }
    }
#endif
    return true;
}

} // namespace

bool isInputTerminal()
{
    return isTerminal(stdin);
}

bool isErrorTerminal()
{
    return isTerminal(stderr);
}

bool askYesNo(const QString &question, const std::function<bool()> &isInterrupted)
{
    static const QStringList yes{QStringLiteral("y"), QStringLiteral("yes"), QStringLiteral("д"), QStringLiteral("да")};
    std::fprintf(stderr, "%s [y/N] ", qPrintable(question));
    std::fflush(stderr);
    std::array<char, 64> line{};
    if (!waitForInput(isInterrupted) || !std::fgets(line.data(), static_cast<int>(line.size()), stdin)) {
        std::fputc('\n', stderr);
        return false;
    }
    return yes.contains(QString::fromLocal8Bit(line.data()).trimmed().toLower());
}

void showProgress(const QString &text)
{
    static qsizetype shown = 0;
    if (!isErrorTerminal()) {
        return;
    }
    const QString wiped = text.leftJustified(shown);
    std::fprintf(stderr, text.isEmpty() ? "\r%s\r" : "\r%s", qPrintable(wiped));
    std::fflush(stderr);
    shown = text.size();
}

} // namespace gorizont::tool
