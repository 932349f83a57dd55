#include "app/tool/interruption.h"

#include <atomic>
#include <csignal>

namespace gorizont::tool {

namespace {

std::atomic<Line *> interruptible{nullptr};
static_assert(std::atomic<Line *>::is_always_lock_free && std::atomic_bool::is_always_lock_free);

/// Line::interrupt() only stores an atomic, so it is allowed here.
extern "C" void onInterrupt(int number)
{
#ifdef Q_OS_WIN
    std::signal(number, onInterrupt); // Windows forgets it
#else
    static_cast<void>(number);
#endif
    if (Line *line = interruptible.load()) {
        line->interrupt();
    }
}

void handle(int number)
{
#ifdef Q_OS_WIN
    std::signal(number, onInterrupt);
#else
    struct sigaction action = {};
    action.sa_handler = onInterrupt; // without SA_RESTART: a question to the user ends, too
    sigaction(number, &action, nullptr);
#endif
}

} // namespace

Interruption::Interruption(Line &line)
{
    interruptible = &line;
    handle(SIGINT);
    handle(SIGTERM);
}

Interruption::~Interruption()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    interruptible = nullptr;
}

} // namespace gorizont::tool
