#include "base/math.h"
#include "reference/geometry.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using OctahedralProbe = GpuTest;

struct In {
    std::uint32_t normal, tangent;
    glm::uvec2 unused{0};
};
struct Out {
    glm::vec4 normal, tangent;
};

TEST_F(OctahedralProbe, UnpackedVectorsAreWithin3e7OfTheReference) {
    std::vector<In> inputs;
    RandomInputs random(6);
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 n = random.direction(), t = random.direction();
        inputs.push_back({packNormal(n), packTangent(glm::vec4(t, random.unit() < 0.5F ? -1 : 1))});
    }
    const auto out = evaluate<Out>("octahedral", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        ASSERT_TRUE(isNear(glm::vec3(out[i].normal), reference::unpackNormal(inputs[i].normal), 3e-7)) << i;
        ASSERT_TRUE(isNear(out[i].tangent, reference::unpackTangent(inputs[i].tangent), 3e-7)) << i;
    }
}

TEST_F(OctahedralProbe, AxesComeBackExactly) {
    std::vector<In> inputs;
    std::vector<glm::vec3> axes;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0F, -1.0F}) {
            glm::vec3 v(0);
            v[axis] = sign;
            axes.push_back(v);
            inputs.push_back({packNormal(v), packTangent(glm::vec4(v, sign))});
        }
    const auto out = evaluate<Out>("octahedral", inputs);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        EXPECT_EQ(glm::vec3(out[i].normal), axes[i]) << i;
        EXPECT_EQ(glm::vec3(out[i].tangent), axes[i]) << i;
        EXPECT_EQ(out[i].tangent.w, i % 2 == 0 ? 1 : -1);
    }
}

}  // namespace
}  // namespace vkpt
