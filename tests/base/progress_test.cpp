#include "base/progress.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

TEST(ProgressLine, SaysShareRateAndTimeLeft) {
    EXPECT_EQ(progressLine(1000000, 4000000, 2, 8), "[##......]  25 %  0.50 M paths/s  0:06 left");
    EXPECT_EQ(progressLine(1, 3600001, 1, 4), "[....]   0 %  0.00 M paths/s  1000:00:00 left");
}

TEST(ProgressLine, IsSilentOnWhatItCannotKnow) {
    EXPECT_EQ(progressLine(0, 100, 3, 4), "[....]   0 %");
    EXPECT_EQ(progressLine(100, 100, 1, 4), "[####] 100 %  0.00 M paths/s");
    EXPECT_EQ(progressLine(0, 0, 0, 4), "[####] 100 %");
}

TEST(ProgressLine, NeverClaimsHundredPercentTooEarly) {
    EXPECT_NE(progressLine(999, 1000, 0, 4).find(" 99 %"), std::string::npos);
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
