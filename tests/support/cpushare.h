#pragma once

#include <chrono>
#include <ctime>

namespace gorizont::test {

/// How busy the process was since this was made, of one core. Something that spins shows about 1 on any machine, however
/// slow or loaded; so tests compare with spins().
class CpuShare
{
public:
    static constexpr double spinning = 0.6;

    bool spins() const
    {
        const auto wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        return static_cast<double>(std::clock() - m_cpu) / CLOCKS_PER_SEC > spinning * wall;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::clock_t m_cpu = std::clock();
};

} // namespace gorizont::test
