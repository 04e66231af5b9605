#include "base/progress.h"

#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vkpt {
namespace {

std::string clockTime(double seconds) {
    const auto s = static_cast<std::uint64_t>(std::ceil(seconds));
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                    : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

std::string progressLine(std::uint64_t done, std::uint64_t total, double seconds, int width, std::string_view unit) {
    const double share = total == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
    const auto filled = static_cast<std::size_t>(share * width);
    std::string line = fmt::format("[{}{}] {:3.0f} %", std::string(filled, '#'),
                                   std::string(static_cast<std::size_t>(width) - filled, '.'), std::floor(100 * share));
    if (done == 0 || seconds <= 0) return line;
    const double rate = static_cast<double>(done) / seconds;
    line += fmt::format("  {:.2f} M {}/s", rate * 1e-6, unit);
    if (done < total) line += fmt::format("  {} left", clockTime(static_cast<double>(total - done) / rate));
    return line;
}

ProgressBar::ProgressBar(bool enabled, std::string_view unit)
    : enabled_(enabled && ::isatty(STDERR_FILENO) == 1), unit_(unit), start_(Clock::now()), last_(start_) {}

ProgressBar::~ProgressBar() {
    if (shown_) std::fputs(kWipeLine, stderr);
}

void ProgressBar::update(std::uint64_t done, std::uint64_t total) {
    const auto now = Clock::now();
    if (!enabled_ || (shown_ && now - last_ < std::chrono::milliseconds(100))) return;
    last_ = now;
    shown_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::fputs((kWipeLine + progressLine(done, total, seconds, kBarWidth, unit_)).c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace vkpt
