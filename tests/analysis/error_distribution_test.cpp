// The error of a render over the screen: a plane under an area light, by the CPU reference.
#include <gtest/gtest.h>

#include "analysis/spectrum.h"
#include "reference/test_scene.h"

namespace vkpt {
namespace {

/// A plane under a quad light. The window is so small that the light on it is as good as uniform: what varies over the
/// screen is the error.
SceneArrays litPlane() {
    test::SceneBuilder builder;
    builder.quad(builder.material(test::matte(glm::vec3(0.7F))), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    builder.quad(builder.material(test::emitter(glm::vec3(10))), {1, -2, 6}, {0, 6, 0}, {6, 0, 0});
    return builder.build();
}

class LitPlane : public testing::TestWithParam<std::uint32_t> {
protected:
    /// Share of the error's power below a quarter of Nyquist, of equal totals; mean over seeds.
    [[nodiscard]] double lowShare(SamplerId sampler, std::uint32_t seeds) const {
        double share = 0;
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            RenderOptions options = test::viewAlongZ(128, 0.002F, GetParam(), 1);
            options.sampler = sampler;
            options.params.seed = seed;
            share += imageSpectrum(filmToImage(renderReference(scene_, options)), 1).share(16) / seeds;
        }
        return share;
    }
    SceneArrays scene_ = litPlane();
};

TEST_P(LitPlane, ErrorLacksLowFrequencies) {
    const double random = lowShare(SamplerId::Random, 2);
    EXPECT_LT(lowShare(SamplerId::Zsobol, 8), 0.5 * random);
    EXPECT_LT(lowShare(SamplerId::Bluenoise, 8), 0.5 * random);  // from 0.2 to 0.65 at 4 samples, by seed
    EXPECT_NEAR(lowShare(SamplerId::Sobol, 2), random, 0.2 * random) << "white, as random's is";
}

INSTANTIATE_TEST_SUITE_P(Samples, LitPlane, testing::Values(1U, 4U), testing::PrintToStringParamName());

}  // namespace
}  // namespace vkpt
