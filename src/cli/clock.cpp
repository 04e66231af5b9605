#include "cli/clock.h"

#include <sys/resource.h>

#include <chrono>

namespace vkpt {
namespace {

const std::chrono::steady_clock::time_point kStart = std::chrono::steady_clock::now();

}  // namespace

double secondsSinceStart() { return std::chrono::duration<double>(std::chrono::steady_clock::now() - kStart).count(); }

unsigned long peakHostBytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<unsigned long>(usage.ru_maxrss) * 1024UL;  // Linux counts in KiB
}

}  // namespace vkpt
