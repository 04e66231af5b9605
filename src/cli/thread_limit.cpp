#include "cli/thread_limit.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "base/cpu.h"

namespace vkpt {
namespace {

/// Lavapipe gives each of its threads the same share of a dispatch beforehand. With several a core no core waits long
/// for the slowest.
constexpr unsigned kDriverThreadsACore = 3;

std::string driverThreads(unsigned threads) {
    const unsigned all = kDriverThreadsACore * static_cast<unsigned>(tbb::info::default_concurrency());
    return std::to_string(threads > 0 ? threads : all);
}

}  // namespace

struct ThreadLimit::Impl {
    /// A variable of the environment while it lives, where the user has not set it. Drivers read theirs when they are
    /// loaded.
    class EnvironmentDefault {
    public:
        EnvironmentDefault(const char* name, const std::string& value)
            : name_(std::getenv(name) == nullptr && !value.empty() ? name : nullptr) {
            if (name_ != nullptr) ::setenv(name_, value.c_str(), 0);
        }
        ~EnvironmentDefault() {
            if (name_ != nullptr) ::unsetenv(name_);
        }
        EnvironmentDefault(const EnvironmentDefault&) = delete;
        EnvironmentDefault& operator=(const EnvironmentDefault&) = delete;

    private:
        const char* name_;
    };

    explicit Impl(unsigned threads)
        : lavapipeThreads("LP_NUM_THREADS", driverThreads(threads)),
          lavapipeWidth("LP_NATIVE_VECTOR_WIDTH", computes512Bits() ? "512" : "") {
        if (threads > 0) control.emplace(tbb::global_control::max_allowed_parallelism, threads);
    }

    EnvironmentDefault lavapipeThreads, lavapipeWidth;
    std::optional<tbb::global_control> control;
};

ThreadLimit::ThreadLimit(unsigned threads) : impl_(std::make_unique<Impl>(threads)) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace vkpt
