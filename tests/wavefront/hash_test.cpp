#include "reference/hash.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using HashProbe = GpuTest;

struct Out {
    glm::uvec4 hash;
    glm::vec4 unit;
};

TEST_F(HashProbe, EqualsReferenceAndStaysBelowOne) {
    std::vector<glm::uvec4> inputs{
        {0, 0, 0, 0}, {~0U, ~0U, ~0U, ~0U}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0x80000000}};
    RandomInputs random(1);
    for (int i = 0; i < 4000; ++i) inputs.push_back({random.bits(), random.bits(), random.bits(), random.bits()});
    const auto out = evaluate<Out>("hash", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::uvec4 expected = reference::hash(inputs[i]);
        ASSERT_EQ(out[i].hash, expected) << i;
        for (int c = 0; c < 4; ++c) {
            ASSERT_EQ(out[i].unit[c], reference::toUnit(expected[c])) << i;
            ASSERT_TRUE(out[i].unit[c] >= 0 && out[i].unit[c] < 1) << i;
        }
    }
}

}  // namespace
}  // namespace vkpt
