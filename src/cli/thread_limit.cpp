#include "cli/thread_limit.h"

#include <oneapi/tbb/global_control.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

namespace vkpt {
namespace {

constexpr const char* kLavapipeThreads = "LP_NUM_THREADS";  // read when the driver is loaded

/// Lavapipe gives each of its threads the same share of a dispatch at once. Several a core level out what one is late
/// by.
constexpr unsigned kDriverThreadsACore = 3;

}  // namespace

struct ThreadLimit::Impl {
    explicit Impl(unsigned threads) : setsDriver(std::getenv(kLavapipeThreads) == nullptr) {
        if (threads > 0) control.emplace(tbb::global_control::max_allowed_parallelism, threads);
        const unsigned ofDriver = threads > 0 ? threads : kDriverThreadsACore * std::thread::hardware_concurrency();
        if (setsDriver && ofDriver > 0) ::setenv(kLavapipeThreads, std::to_string(ofDriver).c_str(), 0);
    }
    ~Impl() {
        if (setsDriver) ::unsetenv(kLavapipeThreads);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    std::optional<tbb::global_control> control;
    bool setsDriver;
};

ThreadLimit::ThreadLimit(unsigned threads) : impl_(std::make_unique<Impl>(threads)) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace vkpt
