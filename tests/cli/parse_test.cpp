#include "cli/parse.h"

#include <gtest/gtest.h>

#include "scene/pixel_filter.h"

namespace vkpt {
namespace {

TEST(Parse, Sizes) {
    EXPECT_EQ(parseSize("960x540"), glm::uvec2(960, 540));
    EXPECT_EQ(parseSize("1x65535"), glm::uvec2(1, 65535));
    for (const char* bad :
         {"", "960", "960x", "x540", "0x4", "4x0", "65536x1", "-1x4", "4x4x4", "4X4", "4.5x4", " 4x4"})
        EXPECT_FALSE(parseSize(bad)) << bad;
}

TEST(Parse, SampleRanges) {
    const auto range = parseSampleRange("64:128");
    ASSERT_TRUE(range);
    EXPECT_EQ(range->begin, 64U);
    EXPECT_EQ(range->end, 128U);
    for (const char* bad : {"", "64", "64:", ":64", "64:64", "65:64", "-1:4", "0:4294967296"})
        EXPECT_FALSE(parseSampleRange(bad)) << bad;
}

TEST(Parse, Vectors) {
    EXPECT_EQ(parseVec3("1.8,-1,2e1"), glm::vec3(1.8F, -1, 20));
    EXPECT_EQ(parseVec3("-.5,0,0"), glm::vec3(-0.5F, 0, 0));
    for (const char* bad : {"", "1,2", "1,2,3,4", "1,2,", "a,b,c", "1 ,2,3", "nan,0,0", "inf,0,0", "1e99,0,0"})
        EXPECT_FALSE(parseVec3(bad)) << bad;
}

TEST(Parse, ColoursAreNotNegativeAndOrbitsHaveARadius) {
    EXPECT_EQ(parseColor("0,0.5,7"), glm::vec3(0, 0.5F, 7));
    EXPECT_FALSE(parseColor("0,-0.5,7"));
    EXPECT_TRUE(parseOrbit("-30,75,3"));
    EXPECT_FALSE(parseOrbit("30,75,0"));
    EXPECT_FALSE(parseOrbit("30,75,-1"));
}

TEST(Parse, RussianRoulette) {
    EXPECT_EQ(parseRoulette("off")->mode, kRouletteOff);
    EXPECT_EQ(parseRoulette("throughput")->mode, kRouletteThroughput);
    EXPECT_EQ(parseRoulette("fixed:0.25")->mode, kRouletteFixed);
    EXPECT_EQ(parseRoulette("fixed:0.25")->survival, 0.25F);
    EXPECT_TRUE(parseRoulette("fixed:1"));
    for (const char* bad : {"", "fixed", "fixed:", "fixed:0", "fixed:0.0009", "fixed:1.1", "fixed:-1", "on"})
        EXPECT_FALSE(parseRoulette(bad)) << bad;
}

TEST(Parse, PixelFilters) {
    for (const FilterInfo& info : kFilters) {
        EXPECT_EQ(parseFilter(info.name)->id, info.id);
        EXPECT_EQ(parseFilter(info.name)->radius, info.radius);
        EXPECT_EQ(parseFilter(std::string(info.name) + ":1.25")->radius, 1.25F);
    }
    for (const char* bad : {"", "Box", "box:", "box:0", "tent:-1", "tent:17", "tent:1:2", ":1", "sinc"})
        EXPECT_FALSE(parseFilter(bad)) << bad;
}

TEST(Parse, Backgrounds) {
    EXPECT_EQ(parseBackground("env")->mode, kBackgroundEnvironment);
    EXPECT_EQ(parseBackground("transparent")->mode, kBackgroundTransparent);
    EXPECT_EQ(parseBackground("0.1,0.2,0.3")->mode, kBackgroundColor);
    EXPECT_EQ(parseBackground("0.1,0.2,0.3")->color, glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_FALSE(parseBackground("black"));
}

TEST(Parse, LightGroups) {
    EXPECT_FALSE(parseLightGroups("none")->on);
    EXPECT_TRUE(parseLightGroups("all")->on);
    EXPECT_TRUE(parseLightGroups("all")->names.empty());
    EXPECT_EQ(parseLightGroups("key light,fill")->names, (std::vector<std::string>{"key light", "fill"}));
    for (const char* text : {"", ",", "a,", ",a", "a,,b"}) EXPECT_FALSE(parseLightGroups(text)) << text;
}

TEST(Parse, Environments) {
    using Kind = EnvironmentChoice::Kind;
    EXPECT_EQ(parseEnvironment("none")->kind, Kind::None);
    EXPECT_EQ(parseEnvironment("studio")->kind, Kind::Studio);
    EXPECT_EQ(parseEnvironment("1,1,1")->kind, Kind::Color);
    EXPECT_EQ(parseEnvironment("sky,1.hdr")->kind, Kind::File);
    EXPECT_EQ(parseEnvironment("sky.exr")->file, "sky.exr");
    for (const char* text : {"", "1,-1,1"}) EXPECT_FALSE(parseEnvironment(text)) << text;
}

TEST(Parse, NumbersAreTheWholeText) {
    EXPECT_EQ(parseNumber<unsigned>("42"), 42U);
    EXPECT_FALSE(parseNumber<unsigned>("42x"));
    EXPECT_FALSE(parseNumber<unsigned>("-1"));
    EXPECT_FALSE(parseNumber<unsigned>("1e3"));
    EXPECT_FALSE(numberWithin(1U)("0"));
    EXPECT_FALSE(numberWithin(0.01F, 179.0F)("180"));
    EXPECT_TRUE(numberWithin(0.01F, 179.0F)("179"));
}

}  // namespace
}  // namespace vkpt
