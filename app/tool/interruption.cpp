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
    std::signal(number, onInterrupt); // some systems forget it
    if (Line *line = interruptible.load()) {
        line->interrupt();
    }
}

} // namespace

Interruption::Interruption(Line &line)
{
    interruptible = &line;
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

Interruption::~Interruption()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    interruptible = nullptr;
}

} // namespace gorizont::tool
