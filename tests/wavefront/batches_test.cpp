#include "wavefront/batches.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

TEST(Batches, BandsAreWholeRowsThatCoverTheFilmOnce) {
    for (const std::uint32_t width : {1U, 7U, 640U, 65536U})
        for (const std::uint32_t height : {1U, 2U, 481U, 65535U})
            for (const std::uint64_t most : {std::uint64_t{1}, std::uint64_t{1000}, std::uint64_t{1} << 21U}) {
                std::uint64_t next = 0;
                for (const Band& band : makeBands(width, height, most)) {
                    ASSERT_EQ(band.firstPixel, next);
                    ASSERT_TRUE(band.pixelCount > 0 && band.pixelCount % width == 0);
                    ASSERT_TRUE(band.pixelCount <= most || band.pixelCount == width) << "more than fits, but one row";
                    next += band.pixelCount;
                }
                ASSERT_EQ(next, std::uint64_t{width} * height);
            }
}

TEST(Batches, PassesHoldAtLeastOneSampleAndAtMostWhatIsLeft) {
    EXPECT_EQ(samplesPerPass(64, 1U << 18U, 0, 1024), 1024U);
    EXPECT_EQ(samplesPerPass(64, 1U << 18U, 0, 1000000), 4096U) << "lavapipe's loop budget";
    EXPECT_EQ(samplesPerPass(1000, 10, 0, 64), 1U) << "more pixels than slots";
    EXPECT_EQ(samplesPerPass(1000, 5000, 0, 3), 3U);
    EXPECT_EQ(samplesPerPass(1000, 5999, 0, 64), 5U);
}

TEST(Batches, LaterPassesOfLargerFilmsTakeSeveralSamplesForSecondsAtMost) {
    EXPECT_EQ(samplesPerPass(512 * 512, 1U << 18U, 0, 64), 1U) << "a picture soon";
    EXPECT_EQ(samplesPerPass(512 * 512, 1U << 18U, 1, 63), 16U);
    EXPECT_EQ(samplesPerPass(512 * 512, 1U << 18U, 49, 15), 15U);
    EXPECT_EQ(samplesPerPass(1920 * 1080, 1U << 18U, 1, 63), 2U);
    EXPECT_EQ(samplesPerPass(std::uint64_t{1} << 40U, 1U << 18U, 1, 63), 1U);
}

}  // namespace
}  // namespace vkpt
