// The progress line of a long computation.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace vkpt {

inline constexpr int kBarWidth = 30;                  ///< in characters
inline constexpr const char* kWipeLine = "\r\x1b[K";  ///< on a terminal: to the line's start, then clear to its end

/// "[#####.....]  50 %  1.02 M paths/s  0:12 left": what the line says of `done` units. seconds: since the start;
/// width: of the bar in characters. Nothing is said about rate or time before they can be known.
[[nodiscard]] std::string progressLine(std::uint64_t done, std::uint64_t total, double seconds, int width = kBarWidth,
                                       std::string_view unit = "paths");

/// Rewrites one line of stderr, ten times a second at most, and wipes it at the end. Silent where stderr is no
/// terminal or `enabled` is false.
class ProgressBar {
public:
    explicit ProgressBar(bool enabled, std::string_view unit = "paths");
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();
    void update(std::uint64_t done, std::uint64_t total);
    /// Rate and time left count from now on, rather than from construction.
    void restart() { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    bool enabled_, shown_ = false;
    std::string unit_;
    Clock::time_point start_, last_;
};

}  // namespace vkpt
