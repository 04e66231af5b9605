#include "scene/environment.h"

#include "reference/lights/environment.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using EnvironmentProbe = GpuTest;

struct In {
    glm::vec4 direction, u;
};
struct Out {
    glm::vec3 radiance;
    float pdf;
    glm::vec3 sampled;
    float sampledPdf;
};

/// Random sky with a sun and a black patch; widths that are no multiple of four leave padding in the tables.
SceneArrays sky(std::uint32_t width, std::uint32_t height, float rotationDegrees) {
    EnvironmentMap map{width, height, {}};
    RandomInputs random(18);
    for (std::uint32_t i = 0; i < width * height; ++i) map.texels.push_back(random.inBox({0, 0, 0}, {1, 1, 1}));
    map.texels[width * height / 3] = {5000, 4000, 3000};
    if (width * height > 1) map.texels[width * height / 2] = {0, 0, 0};
    SceneArrays arrays;
    addEnvironment(arrays, map, 2, rotationDegrees);
    return arrays;
}

struct Sky {
    std::uint32_t width, height;
    float rotationDegrees;
};
constexpr Sky kSkies[] = {{1, 1, 0}, {2, 1, 90}, {16, 8, 0}, {10, 5, 37}, {33, 17, -120}, {64, 32, 180}};

std::vector<In> directions() {
    std::vector<In> inputs;
    RandomInputs random(19);
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0F, -1.0F}) {
            glm::vec4 d(0);
            d[axis] = sign;
            inputs.push_back({d, glm::vec4(random.square(), 0, 0)});
        }
    for (const float u : {0.0F, 0.25F, 0.5F, 0x1.fffffep-1F})
        for (const float v : {0.0F, 0.25F, 0.5F, 0x1.fffffep-1F})
            inputs.push_back({glm::vec4(random.direction(), 0), {u, v, 0, 0}});
    for (int i = 0; i < 3000; ++i)
        inputs.push_back({glm::vec4(random.direction(), 0), glm::vec4(random.square(), 0, 0)});
    return inputs;
}

/// Calls `check(arrays, inputs, outputs of the probe)` for each of kSkies.
template <typename Check>
void forEverySky(Check&& check) {
    const auto inputs = directions();
    for (const Sky& s : kSkies) {
        SCOPED_TRACE(testing::Message() << s.width << "x" << s.height);
        const SceneArrays arrays = sky(s.width, s.height, s.rotationDegrees);
        check(arrays, inputs, ProbeScene(arrays).evaluate<Out>("environment", inputs));
    }
}

/// Texel position of a world direction, in double.
glm::dvec2 texelPosition(const SceneArrays& a, const glm::dvec3& d) {
    const double c = std::cos(double{a.envRotation}), s = std::sin(double{a.envRotation});
    const glm::dvec3 turned(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
    return reference::environmentUv<double>(glm::normalize(turned)) * glm::dvec2(a.envWidth, a.envHeight);
}

// The angles are within 6e-7; u and v within 3e-7; the filter moves by that times the width.
TEST_F(EnvironmentProbe, RadianceAndPdfEqualReference) {
    forEverySky([](const SceneArrays& arrays, const std::vector<In>& inputs, const std::vector<Out>& out) {
        const reference::Environment environment(arrays);
        int compared = 0;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const glm::vec3 d(inputs[i].direction);
            const double shift = 1e-6 * arrays.envWidth * (1 + 1e-6 / std::max(1e-6, 1 - double{d.y} * d.y));
            const bool atPole = std::abs(d.y) > 0.99999F;
            const double brightest = 1e4;
            ASSERT_TRUE(isNear(out[i].radiance, environment.radiance(d), atPole ? 1e-2 : shift * brightest, 1e-5)) << i;
            const glm::dvec2 p = texelPosition(arrays, glm::dvec3(d)), edge = glm::abs(p - glm::round(p));
            if (atPole || std::min(edge.x, edge.y) < 1e-6 * arrays.envWidth) continue;  // either cell will do
            ASSERT_EQ(out[i].pdf, environment.pdf(d)) << i;
            ++compared;
        }
        EXPECT_GT(compared, 2900);
    });
}

TEST_F(EnvironmentProbe, SampledDirectionsAndPdfsEqualReference) {
    forEverySky([](const SceneArrays& arrays, const std::vector<In>& inputs, const std::vector<Out>& out) {
        const reference::Environment environment(arrays);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const auto expected = environment.sample(glm::vec2(inputs[i].u));
            ASSERT_EQ(out[i].sampledPdf, expected.pdf) << i;
            // sin = sqrt(1 - cos^2) rounds by 1e-7 / sin.
            const double sine = std::sqrt(std::max(1e-7, 1 - double{expected.direction.y} * expected.direction.y));
            ASSERT_TRUE(isNear(out[i].sampled, expected.direction, 1e-6 + 3e-7 / sine)) << i;
        }
    });
}

}  // namespace
}  // namespace vkpt
