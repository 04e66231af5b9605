// Against double: Vulkan itself allows sin and cos 2^-11 and atan 4096 ulp, hence functions of our own.
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using TrigonometryProbe = GpuTest;

struct In {
    float turns = 0, y = 0, x = 1, cosine = 0;
};
struct Out {
    glm::vec2 cosSin;
    float angle, arcCosine;
};

TEST_F(TrigonometryProbe, CosineAndSineAreWithin2e7) {
    std::vector<In> inputs;
    for (int i = -4096; i <= 4096; ++i) inputs.push_back({.turns = static_cast<float>(i) / 1024});
    RandomInputs random(2);
    for (int i = 0; i < 8000; ++i) inputs.push_back({.turns = random.between(-1, 1)});
    const auto out = evaluate<Out>("trigonometry", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double angle = 2 * M_PI * double{inputs[i].turns};
        ASSERT_TRUE(isNear(out[i].cosSin, glm::dvec2(std::cos(angle), std::sin(angle)), 2e-7)) << inputs[i].turns;
    }
}

TEST_F(TrigonometryProbe, ArcTangentIsWithin3e7InEveryQuadrant) {
    std::vector<In> inputs;
    for (const float y : {-2.0F, -1.0F, -0.41421356F, -1e-20F, 0.0F, 1e-20F, 0.41421356F, 1.0F, 2.0F})
        for (const float x : {-2.0F, -1.0F, -0.41421356F, 0.0F, 0.41421356F, 1.0F, 2.0F})
            inputs.push_back({0, y, x, 0});
    RandomInputs random(3);
    for (int i = 0; i < 8000; ++i) {
        const float size = std::exp(random.between(-20, 20));
        inputs.push_back({0, random.between(-1, 1) * size, random.between(-1, 1) * size, 0});
    }
    const auto out = evaluate<Out>("trigonometry", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double expected = std::atan2(double{inputs[i].y}, double{inputs[i].x});
        ASSERT_TRUE(isNear(out[i].angle, expected, 3e-7)) << "atan2(" << inputs[i].y << ", " << inputs[i].x << ")";
    }
}

TEST_F(TrigonometryProbe, ArcCosineIsWithin6e7UpToItsEnds) {
    std::vector<In> inputs;
    for (const float c : {-1.0F, -0.99999994F, -0.9999999F, -1e-30F, 0.0F, 0.5F, 0.9999999F, 0.99999994F, 1.0F})
        inputs.push_back({.cosine = c});
    for (int i = -4096; i <= 4096; ++i) inputs.push_back({.cosine = static_cast<float>(i) / 4096});
    const auto out = evaluate<Out>("trigonometry", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        ASSERT_TRUE(isNear(out[i].arcCosine, std::acos(double{inputs[i].cosine}), 6e-7)) << inputs[i].cosine;
}

}  // namespace
}  // namespace vkpt
