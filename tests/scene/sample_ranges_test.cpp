#include "scene/sample_ranges.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

const SampleRanges kTwo{{0, 32}, {48, 64}};

TEST(SampleRanges, CountAndText) {
    EXPECT_EQ(countSamples(kTwo), 48U);
    EXPECT_EQ(countSamples({}), 0U);
    EXPECT_EQ(rangesText(kTwo), "0:32,48:64");
    EXPECT_EQ(rangesText({}), "none");
}

TEST(SampleRanges, TextsReadBack) {
    for (const SampleRanges& ranges : {kTwo, SampleRanges{}, SampleRanges{{7, 8}}, SampleRanges{{0, 0xffffffffU}}})
        EXPECT_EQ(parseSampleRanges(rangesText(ranges)), ranges);
    for (const char* text : {"", "0", "0:", ":1", "1:1", "2:1", "0:2,", "0:2,2:3", "0:2,1:3", "4:5,0:2", "0:4294967296",
                             "0:2 ", "-1:2", "0:2;4:5"})
        EXPECT_FALSE(parseSampleRanges(text)) << text;
}

TEST(SampleRanges, OverlapNamesTheFirstIndicesHeldTwice) {
    EXPECT_FALSE(overlapOf(kTwo, {{32, 48}}));
    EXPECT_FALSE(overlapOf(kTwo, {{32, 40}, {64, 99}}));
    EXPECT_FALSE(overlapOf(kTwo, {}));
    EXPECT_EQ(overlapOf(kTwo, {{32, 50}}), (SampleRange{48, 50}));
    EXPECT_EQ(overlapOf(kTwo, {{0, 64}}), (SampleRange{0, 32}));
    EXPECT_EQ(overlapOf({{10, 11}}, kTwo), (SampleRange{10, 11}));
}

TEST(SampleRanges, UniteJoinsWhatTouches) {
    EXPECT_EQ(unite(kTwo, {{32, 48}}), (SampleRanges{{0, 64}}));
    EXPECT_EQ(unite({{32, 48}}, kTwo), (SampleRanges{{0, 64}}));
    EXPECT_EQ(unite(kTwo, {{40, 44}}), (SampleRanges{{0, 32}, {40, 44}, {48, 64}}));
    EXPECT_EQ(unite({}, kTwo), kTwo);
    EXPECT_EQ(unite({{0, 9}}, {{2, 3}, {4, 12}}), (SampleRanges{{0, 12}}));
}

TEST(SampleRanges, MissingIsWhatIsNotHeld) {
    EXPECT_EQ(missingFrom({0, 64}, kTwo), (SampleRanges{{32, 48}}));
    EXPECT_EQ(missingFrom({0, 80}, kTwo), (SampleRanges{{32, 48}, {64, 80}}));
    EXPECT_EQ(missingFrom({16, 40}, kTwo), (SampleRanges{{32, 40}}));
    EXPECT_EQ(missingFrom({0, 64}, {}), (SampleRanges{{0, 64}}));
    EXPECT_EQ(missingFrom({8, 24}, kTwo), (SampleRanges{}));
    EXPECT_EQ(missingFrom({70, 80}, kTwo), (SampleRanges{{70, 80}}));
}

}  // namespace
}  // namespace vkpt
