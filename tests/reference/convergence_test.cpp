// All estimators converge to one image on the reference. tests/wavefront has the same for the device.
#include "convergence.h"

namespace vkpt {
namespace {

using namespace test;

class ConvergenceIn : public testing::TestWithParam<ConvergenceScene> {};

TEST_P(ConvergenceIn, OfEveryEstimatorAndSampler) {
    expectOneImage(GetParam().make(), estimatorsIn(GetParam()), onReference);
}

INSTANTIATE_TEST_SUITE_P(Full, ConvergenceIn, testing::ValuesIn(kConvergenceScenes),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Convergence, OfSomeEstimators) { expectOneImage(smallCornellBox(), someEstimators(), onReference); }

// The test's power: light counted twice by a hundredth is seen.
TEST(Convergence, IsDeniedToWhatGainsOnePercentFull) {
    const ConvergenceCase c = glassRoom();
    const RenderSeed reference = referenceOf(c);
    const RenderSeed brighter = [&](std::uint32_t seed) {
        Image image = reference(seed);
        for (float& value : image.pixels) value *= 1.01F;
        return image;
    };
    const std::size_t estimators = estimatorsIn({"glass", glassRoom}).size();
    EXPECT_FALSE(compareToReference(brighter, reference, estimators).agrees());
    EXPECT_TRUE(compareToReference(reference, reference, estimators).agrees());
}

}  // namespace
}  // namespace vkpt
