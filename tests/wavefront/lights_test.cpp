#include "reference/light.h"
#include "scene/environment.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"
#include "wavefront/test_scenes.h"

namespace vkpt {
namespace {

using LightsProbe = GpuTest;

struct In {
    glm::vec3 from;
    float uLight;
    glm::vec4 u;
};
struct Out {
    glm::vec3 wi;
    float pdf;
    glm::vec3 radiance;
    float infinite;
    glm::vec3 target;
    float delta;
};

std::vector<In> pointsAmong(int count, std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    for (int i = 0; i < count; ++i)
        inputs.push_back({random.inBox({-3, 0, -3}, {3, 3, 3}), random.unit(), glm::vec4(random.square(), 0, 0)});
    return inputs;
}

const LightRecord& chosenLight(const SceneArrays& arrays, const In& in) {
    return arrays.lights[reference::sampleTable(arrays.lightCdf, in.uLight).index];
}

/// Cosine at a triangle light towards the point.
double cosineAt(const LightRecord& light, const glm::dvec3& wi) {
    const glm::dvec3 a(light.a), n = glm::cross(glm::dvec3(light.b) - a, glm::dvec3(light.c) - a);
    return std::abs(glm::dot(glm::normalize(n), wi));
}

// Directions: the rounding of the point on the light, 3e-7 of its size, over the distance. Their pdf divides by the
// cosine, which is off by as much.
void compareSamples(const SceneArrays& arrays, const std::vector<In>& inputs, std::array<int, 6>& lit) {
    const reference::Lights lights(arrays);
    const auto out = ProbeScene(arrays).evaluate<Out>("lights", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        const LightRecord& light = chosenLight(arrays, in);
        const auto expected = lights.sample(in.from, in.uLight, glm::vec2(in.u));
        SCOPED_TRACE(testing::Message() << i << ": light of kind " << light.kind);
        if (!expected) {
            ASSERT_TRUE(out[i].radiance == glm::vec3(0) || out[i].pdf <= 0);
            continue;
        }
        const bool triangle = light.kind <= kLightTriangleTwoSided, sky = light.kind == kLightEnvironment;
        const double distance = expected->infinite ? 1 : glm::distance(expected->end, in.from);
        const double angle = sky ? 2e-5 : 1e-6 + 3e-6 / distance;
        const double cosine = triangle ? cosineAt(light, glm::dvec3(expected->wi)) : 1;
        ASSERT_TRUE(isNear(out[i].wi, expected->wi, angle));
        ASSERT_TRUE(isNear(out[i].pdf, expected->pdf, 0, 1e-5 + 4 * angle / cosine));
        ASSERT_TRUE(isNear(out[i].radiance, expected->radiance, sky ? 1e-2 : 2e-5, 1e-5 + 4 * angle));
        ASSERT_EQ(out[i].infinite != 0, expected->infinite);
        ASSERT_EQ(out[i].delta != 0, expected->punctual);
        ASSERT_TRUE(isNear(out[i].target, expected->infinite ? expected->wi : expected->end,
                           expected->infinite ? angle : 2e-6));
        if (glm::length(expected->radiance) > 0) ++lit[light.kind];
    }
}

TEST_F(LightsProbe, SamplesOfEveryKindEqualReference) {
    SceneArrays arrays = makeArrays(makeLamps());
    EnvironmentMap map{6, 4, {}};
    RandomInputs random(40);
    for (int i = 0; i < 24; ++i) map.texels.push_back(random.inBox({0, 0, 0}, {1, 1, 1}));
    addEnvironment(arrays, map, 3, 25);
    std::array<int, 6> lit{};
    compareSamples(arrays, pointsAmong(12000, 41), lit);
    for (const uint kind :
         {kLightTriangle, kLightTriangleTwoSided, kLightPoint, kLightSpot, kLightDirectional, kLightEnvironment})
        EXPECT_GT(lit[kind], 30) << "kind " << kind;
}

TEST_F(LightsProbe, ASingleLightNeedsNoTable) {
    Scene scene = makeLamps();
    scene.materials[1].emissive = scene.materials[2].emissive = scene.materials[3].emissive = glm::vec3(0);
    for (const PunctualLight& light : makeLamps().lights) {
        scene.lights = {light};
        const SceneArrays arrays = makeArrays(scene);
        ASSERT_EQ(arrays.lights.size(), 1U);
        std::array<int, 6> lit{};
        compareSamples(arrays, pointsAmong(2000, 42), lit);
        EXPECT_GT(lit[arrays.lights[0].kind], 100);
    }
}

TEST_F(LightsProbe, LightsAreChosenInProportionToTheirPmf) {
    const SceneArrays arrays = makeArrays(makeLamps());
    std::vector<In> inputs;
    const int count = 1 << 14;
    for (int i = 0; i < count; ++i)
        inputs.push_back(
            {{0, 0.5F, 0}, static_cast<float>(i) / static_cast<float>(count), glm::vec4(0.3F, 0.4F, 0, 0)});
    const auto out = ProbeScene(arrays).evaluate<Out>("lights", inputs);
    double spots = 0, expected = 0;  // delta lights: what pdf reports is the pmf itself
    for (const Out& o : out) spots += o.delta != 0 ? 1 : 0;
    for (const LightRecord& light : arrays.lights)
        if (light.kind >= kLightPoint && light.kind <= kLightDirectional) expected += double{light.pmf};
    EXPECT_NEAR(spots / count, expected, 8.0 / count);
}

}  // namespace
}  // namespace vkpt
