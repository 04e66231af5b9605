// The two renderers take the same decisions: at one sample a pixel they agree but for few pixels, and without bias.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

#include "registry.h"
#include "scene_files.h"
#include "verify/context.h"
#include "verify/findings.h"
#include "verify/images.h"

namespace vkpt {
namespace {

using Case = std::tuple<std::string, std::string>;  // scene, sampler

/// Every scene with the plain samplers and every sampler with one scene, or all other pairs.
std::vector<Case> casesOf(bool quick) {
    std::vector<Case> cases;
    for (const std::string& scene : sceneNames())
        for (const SamplerInfo& sampler : kSamplers) {
            const bool plain = sampler.id == SamplerId::Random || sampler.id == SamplerId::Sobol;
            if ((plain || scene == "cornell_box") == quick) cases.emplace_back(scene, sampler.name);
        }
    return cases;
}

std::string nameOfCase(const testing::TestParamInfo<Case>& test) {
    return std::get<0>(test.param) + "_" + std::get<1>(test.param);
}

class Parity : public testing::TestWithParam<Case> {};

TEST_P(Parity, FewPixelsPartAndTheMeanDoesNot) {
    const auto& [scene, sampler] = GetParam();
    const Json parity = expectations(scene).at("parity");
    auto options = parity.at("options").get<std::vector<std::string>>();
    for (const char* more : {"--size", "128x96", "--spp", "1", "--sampler"}) options.emplace_back(more);
    options.push_back(sampler);
    const PreparedScene prepared = prepare(scene, options);

    PathDifferences d;
    d.add(renderSeed(prepared, Backend::Vulkan, 0), renderSeed(prepared, Backend::Cpu, 0), 0);

    const double limit = parity.at("kind") == "diffuse" ? 0.001 : 0.01;
    fmt::print("{}, {}: {:.3f} % of {} pixels parted (limit {} %)\n", scene, sampler, 100 * d.partedShare(), d.paths(),
               100 * limit);
    EXPECT_LE(d.partedShare(), limit);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(d.mean(c), 0) << "the image is black: nothing is compared";
        EXPECT_LE(d.meanShare(c), 1) << "channel " << c << " is off by " << d.meanDifference(c);
    }
}

/// With all bounces, some of which magnify rounding: few paths part but those of which it decides.
TEST(FullParity, PathsAgreeAsVerifyJudgesThem) {
    for (const std::string& scene : sceneNames()) {
        SCOPED_TRACE(scene);
        const PreparedScene prepared = prepare(scene, {"--size", "128x72", "--spp", "4"});
        VerifyContext context(prepared.arrays, prepared.options, {});
        Findings findings;
        checkSameSeed(context, findings);
        EXPECT_TRUE(findings.refusal().empty()) << findings.refusal();
        if (const auto& d = findings.disagreement())
            ADD_FAILURE() << d->quantity << ": " << d->what << "\n" << d->where;
    }
}

INSTANTIATE_TEST_SUITE_P(SceneAndSampler, Parity, testing::ValuesIn(casesOf(true)), nameOfCase);
INSTANTIATE_TEST_SUITE_P(FullSceneAndSampler, Parity, testing::ValuesIn(casesOf(false)), nameOfCase);

}  // namespace
}  // namespace vkpt
