#include "base/progress.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

#include "base/log.h"

namespace vkpt {
namespace {

/// What is written to stderr while it is a terminal.
template <class Write>
std::string shownOnATerminal(const Write& write) {
    int screen = -1, terminal = -1;
    if (::openpty(&screen, &terminal, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no terminal");
    ::fcntl(screen, F_SETFL, O_NONBLOCK);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(terminal, STDERR_FILENO);
    write();
    ::dup2(before, STDERR_FILENO);
    std::array<char, 4096> text{};
    const ssize_t size = ::read(screen, text.data(), text.size());
    for (const int descriptor : {before, terminal, screen}) ::close(descriptor);
    return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

TEST(ProgressLine, SaysShareRateAndTimeLeft) {
    EXPECT_EQ(progressLine(1000000, 4000000, 2, 8), "[##......]  25 %  0.50 M paths/s  0:06 left");
    EXPECT_EQ(progressLine(1, 3600001, 1, 4), "[....]   0 %  0.00 M paths/s  1000:00:00 left");
}

TEST(ProgressLine, IsSilentOnWhatItCannotKnow) {
    EXPECT_EQ(progressLine(0, 100, 3, 4), "[....]   0 %");
    EXPECT_EQ(progressLine(100, 100, 1, 4), "[####] 100 %  0.00 M paths/s");
    EXPECT_EQ(progressLine(0, 0, 0, 4), "[####] 100 %");
}

TEST(ProgressLine, NamesItsUnit) {
    EXPECT_EQ(progressLine(3000000, 4000000, 2, 4, "texels"), "[###.]  75 %  1.50 M texels/s  0:01 left");
}

TEST(ProgressLine, NeverClaimsHundredPercentTooEarly) {
    EXPECT_NE(progressLine(999, 1000, 0, 4).find(" 99 %"), std::string::npos);
}

TEST(ProgressBar, IsDrawnOnATerminalAndWipedAtItsEnd) {
    const auto shown = [](bool enabled) {
        return shownOnATerminal([&] { ProgressBar(enabled, "texels").update(0, 4); });
    };
    EXPECT_EQ(shown(true), kWipeLine + progressLine(0, 4, 0) + kWipeLine);
    EXPECT_EQ(shown(false), "");
}

TEST(ProgressBar, GivesWayToMessages) {
    const std::string shown = shownOnATerminal([] {
        setUpLog(Verbosity::Normal);
        spdlog::warn("odd");
    });
    setUpLog(Verbosity::Normal);
    EXPECT_EQ(shown, std::string(kWipeLine) + "vkpt: warning: odd\r\n");
}

TEST(ProgressBar, WritesNothingWhereStderrIsNoTerminal) {
    testing::internal::CaptureStderr();
    {
        ProgressBar bar(true);
        bar.update(1, 2);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace vkpt
