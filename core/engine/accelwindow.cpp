#include "core/engine/accelwindow.h"

namespace gorizont {
void AccelWindow::add(const SampleBlock &) {}
void AccelWindow::clear() {}
std::optional<AccelStatistics> AccelWindow::statistics() const
{
    return std::nullopt;
}
} // namespace gorizont
