#include "cli/thread_limit.h"

#include <oneapi/tbb/global_control.h>

#include <cstdlib>
#include <string>

namespace vkpt {
namespace {

constexpr const char* kLavapipeThreads = "LP_NUM_THREADS";  // read when the driver is loaded

}  // namespace

struct ThreadLimit::Impl {
    explicit Impl(unsigned threads)
        : control(tbb::global_control::max_allowed_parallelism, threads),
          setsDriver(std::getenv(kLavapipeThreads) == nullptr) {
        if (setsDriver) ::setenv(kLavapipeThreads, std::to_string(threads).c_str(), 0);
    }
    ~Impl() {
        if (setsDriver) ::unsetenv(kLavapipeThreads);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    tbb::global_control control;
    bool setsDriver;
};

ThreadLimit::ThreadLimit(unsigned threads) {
    if (threads > 0) impl_ = std::make_unique<Impl>(threads);
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace vkpt
