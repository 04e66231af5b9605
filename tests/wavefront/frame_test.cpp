#include "reference/frame.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using FrameProbe = GpuTest;

struct In {
    glm::vec4 normal, vector;
};
struct Out {
    glm::vec4 t, b, n, local, world;
};

std::vector<In> normals() {
    std::vector<In> inputs;
    RandomInputs random(7);
    const auto add = [&](const glm::vec3& n) { inputs.push_back({glm::vec4(n, 0), glm::vec4(random.direction(), 0)}); };
    for (const float sign : {1.0F, -1.0F}) {
        add({sign, 0, 0});
        add({0, sign, 0});
        add({0, 0, sign});
        add({0.6F, 0.8F * sign, -0.0F});
        add(glm::normalize(glm::vec3(1e-4F, sign * 1e-4F, -1)));
        add(glm::normalize(glm::vec3(1e-20F, 1, sign * 1e-20F)));
    }
    for (int i = 0; i < 4000; ++i) add(random.direction());
    return inputs;
}

TEST_F(FrameProbe, EqualsReferenceWithin1e6) {
    const auto inputs = normals();
    const auto out = evaluate<Out>("frame", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const reference::Frame<float> expected{glm::vec3(inputs[i].normal)};
        const glm::vec3 v(inputs[i].vector);
        ASSERT_TRUE(isNear(glm::vec3(out[i].t), expected.x, 1e-6)) << i;
        ASSERT_TRUE(isNear(glm::vec3(out[i].b), expected.y, 1e-6)) << i;
        ASSERT_TRUE(isNear(glm::vec3(out[i].local), expected.toLocal(v), 1e-6)) << i;
    }
}

TEST_F(FrameProbe, IsOrthonormalRightHandedAndUndoesItself) {
    const auto inputs = normals();
    const auto out = evaluate<Out>("frame", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 t(out[i].t), b(out[i].b), n(out[i].n);
        ASSERT_EQ(glm::vec3(n), glm::vec3(inputs[i].normal));
        ASSERT_TRUE(isNear(glm::dvec3(glm::dot(t, t), glm::dot(b, b), glm::dot(t, b)), glm::dvec3(1, 1, 0), 1e-6)) << i;
        ASSERT_TRUE(isNear(glm::cross(t, b), n, 1e-6)) << i;
        ASSERT_TRUE(isNear(glm::vec3(out[i].world), glm::vec3(inputs[i].vector), 1e-6)) << i;
    }
}

}  // namespace
}  // namespace vkpt
