// All estimators of the device converge to the reference's image.
#include "convergence.h"

#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

class DeviceConvergenceIn : public testing::TestWithParam<test::ConvergenceScene> {};

TEST_P(DeviceConvergenceIn, OfEveryEstimatorAndSampler) {
    test::expectOneImage(GetParam().make(), test::estimatorsIn(GetParam()), onDevice);
}

INSTANTIATE_TEST_SUITE_P(Full, DeviceConvergenceIn, testing::ValuesIn(test::kConvergenceScenes),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DeviceConvergence, OfSomeEstimators) {
    test::expectOneImage(test::smallCornellBox(), test::someEstimators(), onDevice);
}

}  // namespace
}  // namespace vkpt
