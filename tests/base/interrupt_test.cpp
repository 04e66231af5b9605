#include "base/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

namespace vkpt {
namespace {

TEST(Interrupt, FirstSignalSetsTheFlag) {
    const auto once = [] {
        const std::atomic<bool>& stop = catchInterrupt();
        if (stop) std::_Exit(1);
        std::raise(SIGINT);
        std::_Exit(stop ? 0 : 2);
    };
    EXPECT_EXIT(once(), testing::ExitedWithCode(0), "");
}

TEST(Interrupt, SecondSignalKills) {
    const auto twice = [] {
        catchInterrupt();
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::_Exit(0);
    };
    EXPECT_EXIT(twice(), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace vkpt
