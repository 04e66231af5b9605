// The progress line of a long computation.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace vkpt {

/// "[#####.....]  50 %  1.02 M paths/s  0:12 left": what the line says. seconds: since the start; width: of the
/// bar in characters. Nothing is said about rate or time before they can be known.
[[nodiscard]] std::string progressLine(std::uint64_t done, std::uint64_t total, double seconds, int width = 30);

/// Rewrites one line of stderr, ten times a second at most, and wipes it at the end. Silent where stderr is no
/// terminal or `enabled` is false.
class ProgressBar {
public:
    explicit ProgressBar(bool enabled);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();
    void update(std::uint64_t done, std::uint64_t total);

private:
    using Clock = std::chrono::steady_clock;
    bool enabled_, shown_ = false;
    Clock::time_point start_, last_;
};

}  // namespace vkpt
