// Renders of one small scene through the program, for the tests of merging and resuming.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/run_vkpt.h"

namespace vkpt {

using Words = std::vector<std::string>;

class FilmProgram : public testing::Test {
protected:
    [[nodiscard]] RunResult run(const Words& arguments, RunOptions options = {}) const {
        options.folder = folder_.path();
        return runVkpt(arguments, options);
    }
    /// 8 samples of 24x16 pixels with every layer, on `backend`, with more arguments.
    [[nodiscard]] static Words renderWords(const std::string& backend, const Words& more) {
        Words all{"render", VKPT_SCENES "/cornell_box/scene.gltf", "--backend", backend, "--size", "24x16"};
        if (std::ranges::find(more, "--spp") == more.end()) all.insert(all.end(), {"--spp", "8"});
        if (std::ranges::find(more, "--aov") == more.end()) all.insert(all.end(), {"--aov", "all"});
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    void render(const std::string& backend, const Words& more) const {
        const RunResult r = run(renderWords(backend, more));
        ASSERT_EQ(r.code, 0) << r.err;
    }
    [[nodiscard]] std::string bytes(const std::string& file) const { return readText(folder_ / file); }
    void expectSameFile(const std::string& a, const std::string& b) const {
        EXPECT_FALSE(bytes(a).empty()) << a;
        EXPECT_TRUE(bytes(a) == bytes(b)) << a << " and " << b << " differ";
    }
    /// Exit code and one line on stderr that holds every text.
    static void expectFault(const RunResult& r, int code, const Words& texts) {
        EXPECT_EQ(r.code, code) << r.err;
        EXPECT_EQ(r.errLines(), 1) << r.err;
        for (const std::string& text : texts) EXPECT_THAT(r.err, testing::HasSubstr(text));
    }

    TemporaryFolder folder_;
};

}  // namespace vkpt
