// vkpt render --resume and --checkpoint: whatever happens on the way, the file at the end is that of an undisturbed
// run.
#include <chrono>
#include <csignal>
#include <iostream>
#include <random>

#include "cli/film_program.h"
#include "film/read_film.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

class ResumeOn : public FilmProgram, public testing::WithParamInterface<const char*> {
protected:
    /// Long enough to be hit by a kill: some passes, saved one by one.
    [[nodiscard]] static Words longRender(const Words& more) {
        Words words = renderWords(GetParam(), {"--spp", "2500", "--aov", "depth,primitive,variance"});
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    void killAndResume(int kills);
};

void ResumeOn::killAndResume(int kills) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run(longRender({"-o", "whole.exr"})).code, 0);
    const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    const Words words = longRender({"--resume", "r.exr", "--checkpoint", "0", "--verbose"});
    std::mt19937 random(std::random_device{}());
    int killed = 0, left = 0;
    for (int i = 0; i < kills; ++i) {  // in turn soon after a save and at any time
        RunOptions kill{.interruptAfter = i % 2 == 0 ? "saved samples" : "", .signal = SIGKILL};
        kill.delay = std::chrono::milliseconds(random() % (i % 2 == 0 ? 20 : whole.count() + 1));
        const RunResult r = run(words, kill);
        if (r.code == 0) {  // over before it was killed: again from the beginning
            std::filesystem::remove(folder_ / "r.exr");
            continue;
        }
        ASSERT_EQ(r.code, 128 + SIGKILL) << r.err;
        ++killed;
        if (!std::filesystem::exists(folder_ / "r.exr")) continue;
        ++left;
        EXPECT_GT(readFilm(folder_ / "r.exr").film.samples(), 0U) << "a save was torn";
    }
    EXPECT_GT(left, 0) << "no kill left anything to go on from";
    std::cout << killed << " kills, " << left << " of them left samples behind\n";
    const bool held = std::filesystem::exists(folder_ / "r.exr");
    const RunResult interrupted = run(words, {.interruptAfter = "Ctrl-C"});
    EXPECT_TRUE(interrupted.code == 130 || interrupted.code == 0) << interrupted.err;
    EXPECT_THAT(interrupted.err, HasSubstr(held ? "r.exr holds samples 0:" : "starting afresh"));
    ASSERT_EQ(run(words).code, 0);
    expectSameFile("r.exr", "whole.exr");
}

TEST_P(ResumeOn, KilledAtRandomMomentsItEndsAsAnUndisturbedRun) { killAndResume(2); }
TEST_P(ResumeOn, FullKilledOftenItEndsAsAnUndisturbedRun) { killAndResume(12); }

INSTANTIATE_TEST_SUITE_P(Backends, ResumeOn, testing::Values("cpu", "vulkan"));

class Resume : public FilmProgram {};

TEST_F(Resume, AMissingFileIsABeginning) {
    const RunResult r = run(renderWords("cpu", {"--resume", "r.exr"}));
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr("r.exr is not there yet: starting afresh"));
    EXPECT_THAT(folder_.files(), testing::ElementsAre("r.exr")) << "it is the output";
    render("cpu", {"-o", "whole.exr"});
    expectSameFile("r.exr", "whole.exr");
}

TEST_F(Resume, RendersOnlyWhatIsMissing) {
    render("cpu", {"-o", "whole.exr"});
    render("cpu", {"--samples", "2:4", "-o", "r.exr"});
    const RunResult r = run(renderWords("cpu", {"--resume", "r.exr", "-o", "p.png", "--stats", "s.json"}));
    ASSERT_EQ(r.code, 0) << r.err;
    expectSameFile("r.exr", "whole.exr");
    EXPECT_THAT(bytes("s.json"), HasSubstr("\"paths\": " + std::to_string(24 * 16 * 6)));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "p.png"));
    const RunResult again = run(renderWords("cpu", {"--resume", "r.exr"}));
    EXPECT_EQ(again.code, 0);
    EXPECT_THAT(again.err, HasSubstr("all samples are there already"));
    expectSameFile("r.exr", "whole.exr");
}

TEST_F(Resume, TimeLimitsKeepTheTrueRange) {
    const Words words =
        renderWords("cpu", {"--resume", "r.exr", "--spp", "60000", "--aov", "none", "--time-limit", "0.05"});
    std::uint32_t before = 0;
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(run(words).code, 0);
        const FilmRecord record = readFilm(folder_ / "r.exr");
        ASSERT_EQ(record.film.ranges.size(), 1U);
        ASSERT_EQ(record.film.sampleBegin(), 0U);
        ASSERT_GT(record.film.sampleEnd(), before);
        before = record.film.sampleEnd();
    }
    render("cpu", {"--spp", "60000", "--aov", "none", "--samples", "0:" + std::to_string(before), "-o", "same.exr"});
    expectSameFile("r.exr", "same.exr");
}

TEST_F(Resume, RefusesTheFileOfAnotherRender) {
    render("cpu", {"--seed", "1", "-o", "r.exr"});
    const std::string before = bytes("r.exr");
    expectFault(run(renderWords("cpu", {"--resume", "r.exr"})), 4,
                {"r.exr: cannot be resumed: seed is 0 here and 1 there"});
    EXPECT_EQ(bytes("r.exr"), before);
    (void)folder_.write("text.exr", "hello");
    expectFault(run(renderWords("cpu", {"--resume", "text.exr"})), 4, {"text.exr: "});
}

TEST_F(Resume, ASaveThatFailsIsAWarningAndTheRenderGoesOn) {
    const RunResult r =
        runVkpt(renderWords("cpu", {"--spp", "2000", "--aov", "none", "-o", "a.exr", "--checkpoint", "0"}),
                {.folder = folder_.path(), .mostFileBytes = 200});
    EXPECT_EQ(r.code, 4) << "the picture could not be written either";
    EXPECT_THAT(r.err, HasSubstr("warning: no checkpoint: a.exr: cannot write: File too large"));
    EXPECT_THAT(r.err, HasSubstr("2000 samples a pixel in "));
    EXPECT_TRUE(folder_.files().empty());
}

TEST_F(Resume, RefusesOptionsThatCannotSave) {
    expectFault(run(renderWords("cpu", {"--resume", "r.png"})), 64, {"--resume", "r.png"});
    expectFault(run(renderWords("cpu", {"--resume", "r.exr", "--no-film"})), 64, {"--no-film"});
    expectFault(run(renderWords("cpu", {"--checkpoint", "1", "--aov", "none", "-o", "a.png"})), 64, {"--checkpoint"});
    expectFault(run(renderWords("cpu", {"-o", "a.png"})), 64, {"--aov"});
    expectFault(run(renderWords("cpu", {"-o", "a.exr", "--aov", "albedo,bump"})), 64, {"--aov", "albedo,bump"});
    expectFault(run(renderWords("cpu", {"-o", "a.exr", "--checkpoint", "-1"})), 64, {"--checkpoint"});
    EXPECT_TRUE(folder_.files().empty());
}

}  // namespace
}  // namespace vkpt
