#include "scene/aov.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

TEST(Aov, IdsFollowTheTable) {
    for (std::size_t i = 0; i < kAovs.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(kAovs[i].id), i);
}

TEST(Aov, ListsReadBackInTheOrderOfTheTable) {
    for (const AovInfo& aov : kAovs) EXPECT_EQ(aovsText(*parseAovs(aov.name)), aov.name);
    EXPECT_EQ(aovsText(*parseAovs("normal,albedo,normal")), "albedo,normal");
    EXPECT_EQ(*parseAovs(aovsText(kAllAovs)), kAllAovs);
    EXPECT_EQ(*parseAovs("all"), kAllAovs);
    EXPECT_TRUE(parseAovs("none")->empty());
    EXPECT_EQ(aovsText({}), "none");
}

TEST(Aov, OtherTextsAreRefused) {
    for (const char* text : {"", ",", "albedo,", ",albedo", "Albedo", "albedo normal", "all,albedo", "motion"})
        EXPECT_FALSE(parseAovs(text)) << text;
}

}  // namespace
}  // namespace vkpt
