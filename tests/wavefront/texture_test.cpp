#include "reference/texture.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using TextureProbe = GpuTest;

struct In {
    glm::vec2 uv;
    std::uint32_t texture, unused = 0;
};

constexpr glm::uvec2 kSizes[] = {{1, 1}, {4, 4}, {5, 7}, {1, 9}, {64, 3}, {100, 37}, {1023, 2}};

/// Every wrap mode on each axis, both filters, sRGB and linear, without and with a transform, of every size.
SceneArrays textureScene() {
    SceneArrays arrays;
    arrays.features.textures = arrays.features.textureTransforms = true;
    RandomInputs random(15);
    for (const glm::uvec2& size : kSizes) {
        const auto texels = static_cast<std::uint32_t>(arrays.texels.size());
        for (std::uint32_t i = 0; i < size.x * size.y; ++i) arrays.texels.push_back(random.bits());
        for (std::uint32_t wrapS = 0; wrapS < 3; ++wrapS)
            for (std::uint32_t wrapT = 0; wrapT < 3; ++wrapT)
                for (const uint kind : {0U, kTextureSrgb, kTextureNearest, kTextureSrgb | kTextureNearest}) {
                    const uint flags = kind | wrapS << kTextureWrapSShift | wrapT << kTextureWrapTShift;
                    TextureRecord record{texels, size.x | size.y << 16U, flags, 0, {1, 0, 0, 0}, {0, 1, 0, 0}};
                    arrays.textures.push_back(record);
                    record.rowU = {0.8F, -1.5F, 0.25F, 0};
                    record.rowV = {1.25F, 0.6F, -3.5F, 0};
                    arrays.textures.push_back(record);
                }
    }
    return arrays;
}

/// Texel coordinates of a sample before wrapping.
glm::dvec2 texelPosition(const TextureRecord& t, const glm::vec2& uv) {
    const glm::dvec3 uv1(uv, 1);
    return {glm::dot(glm::dvec3(t.rowU), uv1) * (t.size & 0xffffU),
            glm::dot(glm::dvec3(t.rowV), uv1) * (t.size >> 16U)};
}

void compare(const SceneArrays& arrays, const std::vector<In>& inputs) {
    const auto out = ProbeScene(arrays).evaluate<glm::vec4>("texture", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        const TextureRecord& record = arrays.textures[in.texture];
        const glm::dvec2 p = texelPosition(record, in.uv);
        // Rounding of the transform moves the filter by some ulps of the largest term of p.
        const double reach = 1024 + std::max(std::abs(p.x), std::abs(p.y)) +
                             1024 * std::max(std::abs(double{in.uv.x}), std::abs(double{in.uv.y}));
        const double shift = std::min(1.0, reach * 0x1p-21);
        const glm::dvec2 edge = glm::abs(p - glm::round(p));
        if ((record.flags & kTextureNearest) != 0 && std::min(edge.x, edge.y) < shift) continue;
        const glm::vec4 expected = reference::sampleTexture(arrays, in.texture, {in.uv, {}});
        ASSERT_TRUE(isNear(out[i], expected, 1e-6 + 2 * shift, 4e-6))
            << "texture " << in.texture << " flags " << record.flags << " size " << (record.size & 0xffffU) << "x"
            << (record.size >> 16U) << " at " << in.uv.x << ", " << in.uv.y;
    }
}

TEST_F(TextureProbe, EveryWrapFilterAndTransformEqualsReference) {
    const SceneArrays arrays = textureScene();
    std::vector<In> inputs;
    RandomInputs random(16);
    for (std::uint32_t texture = 0; texture < arrays.textures.size(); ++texture) {
        for (const float u : {-1.0F, -0.25F, 0.0F, 0.5F, 1.0F, 2.0F}) inputs.push_back({{u, 1 - u}, texture});
        for (int i = 0; i < 24; ++i)
            inputs.push_back({glm::vec2(random.between(-4, 4), random.between(-4, 4)), texture});
        for (int i = 0; i < 4; ++i)
            inputs.push_back({glm::vec2(random.between(-300, 300), random.between(-300, 300)), texture});
    }
    compare(arrays, inputs);
}

// A float beyond 2^23 is an integer: which texel it names must still be the one that integer wraps to.
TEST_F(TextureProbe, CoordinatesFarOutsideNameTheTexelTheyWrapTo) {
    SceneArrays arrays = textureScene();
    std::vector<In> inputs;
    RandomInputs random(17);
    for (std::uint32_t texture = 0; texture < arrays.textures.size(); texture += 2) {
        TextureRecord& record = arrays.textures[texture];
        if ((record.flags & kTextureNearest) == 0) continue;
        for (const float size : {2e4F, 1e6F, 1e8F, 5e8F}) {
            const float scale = size / static_cast<float>(std::max(record.size & 0xffffU, record.size >> 16U));
            for (const float sign : {1.0F, -1.0F})
                inputs.push_back({glm::vec2(random.between(0.5F, 1), random.between(0.5F, 1)) * scale * sign, texture});
        }
    }
    const auto out = ProbeScene(arrays).evaluate<glm::vec4>("texture", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        ASSERT_TRUE(isNear(out[i], reference::sampleTexture(arrays, inputs[i].texture, {inputs[i].uv, {}}), 1e-6, 4e-6))
            << "texture " << inputs[i].texture << " at " << inputs[i].uv.x << ", " << inputs[i].uv.y;
}

}  // namespace
}  // namespace vkpt
