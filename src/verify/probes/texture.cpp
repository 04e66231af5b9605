#include "reference/texture.h"

#include <cmath>

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec2 uv;
    std::uint32_t texture, unused = 0;
};

constexpr glm::uvec2 kSizes[] = {{1, 1}, {4, 4}, {5, 7}, {1, 9}, {64, 3}, {100, 37}, {1023, 2}};

/// Every wrap mode on each axis, both filters, sRGB and linear, without and with a transform, of every size.
SceneArrays textureScene() {
    SceneArrays arrays;
    arrays.features.maps = 1U << kMapBaseColor;
    arrays.features.textureTransforms = true;
    RandomInputs random(15);
    for (const glm::uvec2& size : kSizes) {
        const auto texels = static_cast<std::uint32_t>(arrays.texels.size());
        for (std::uint32_t i = 0; i < size.x * size.y; ++i) arrays.texels.push_back(random.bits());
        for (std::uint32_t wrapS = 0; wrapS < 3; ++wrapS)
            for (std::uint32_t wrapT = 0; wrapT < 3; ++wrapT)
                for (const uint kind : {0U, kTextureSrgb, kTextureNearest, kTextureSrgb | kTextureNearest}) {
                    const uint flags = kind | wrapS << kTextureWrapSShift | wrapT << kTextureWrapTShift;
                    TextureRecord record{texels, size.x | size.y << 16U, flags, 1, {1, 0, 0, 0}, {0, 1, 0, 0}};
                    arrays.textures.push_back(record);
                    record.rowU = {0.8F, -1.5F, 0.25F, 0};
                    record.rowV = {1.25F, 0.6F, -3.5F, 0};
                    arrays.textures.push_back(record);
                }
    }
    return arrays;
}

std::vector<In> nearCoordinates(const SceneArrays& arrays) {
    std::vector<In> inputs;
    RandomInputs random(16);
    for (std::uint32_t texture = 0; texture < arrays.textures.size(); ++texture) {
        for (const float u : {-1.0F, -0.25F, 0.0F, 0.5F, 1.0F, 2.0F}) inputs.push_back({{u, 1 - u}, texture});
        for (int i = 0; i < 24; ++i)
            inputs.push_back({glm::vec2(random.between(-4, 4), random.between(-4, 4)), texture});
        for (int i = 0; i < 4; ++i)
            inputs.push_back({glm::vec2(random.between(-300, 300), random.between(-300, 300)), texture});
    }
    return inputs;
}

/// Of the untransformed nearest ones. A float beyond 2^23 is an integer: which texel it names must still be the one
/// that integer wraps to.
std::vector<In> farCoordinates(const SceneArrays& arrays) {
    std::vector<In> inputs;
    RandomInputs random(17);
    for (std::uint32_t texture = 0; texture < arrays.textures.size(); texture += 2) {
        const TextureRecord& record = arrays.textures[texture];
        if ((record.flags & kTextureNearest) == 0) continue;
        for (const float size : {2e4F, 1e6F, 1e8F, 5e8F}) {
            const float scale = size / static_cast<float>(std::max(record.size & 0xffffU, record.size >> 16U));
            for (const float sign : {1.0F, -1.0F})
                inputs.push_back({glm::vec2(random.between(0.5F, 1), random.between(0.5F, 1)) * scale * sign, texture});
        }
    }
    return inputs;
}

/// Texel coordinates of a sample before wrapping.
glm::dvec2 texelPosition(const TextureRecord& t, const glm::vec2& uv) {
    const glm::dvec3 uv1(uv, 1);
    return {glm::dot(glm::dvec3(t.rowU), uv1) * (t.size & 0xffffU),
            glm::dot(glm::dvec3(t.rowV), uv1) * (t.size >> 16U)};
}

/// How far rounding may move the filter, in texels: some ulps of the largest term of the position p.
double shiftOf(const In& in, const glm::dvec2& p) {
    const double reach = 1024 + std::max(std::abs(p.x), std::abs(p.y)) +
                         1024 * std::max(std::abs(double{in.uv.x}), std::abs(double{in.uv.y}));
    return std::min(1.0, reach * 0x1p-21);
}

template <class Compare>
void forEach(const ProbeScene& scene, const SceneArrays& arrays, Findings& findings, const std::vector<In>& inputs,
             const Compare& compare) {
    const auto scope = findings.inputs([&](std::size_t i) {
        const TextureRecord& t = arrays.textures[inputs[i].texture];
        return fmt::format("sampleTexture of {}x{} texels, flags {:#x}, {}, at {}", t.size & 0xffffU, t.size >> 16U,
                           t.flags, inputs[i].texture % 2 == 0 ? "untransformed" : "transformed", show(inputs[i].uv));
    });
    const auto out = scene.evaluate<glm::vec4>(findings, "texture", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compare(inputs[i], out[i], reference::sampleTexture(arrays, inputs[i].texture, {inputs[i].uv, {}}));
    }
}

}  // namespace

void checkTexture(VerifyContext& context, Findings& findings) {
    const SceneArrays arrays = textureScene();
    const ProbeScene scene(context.prober(), arrays);
    forEach(scene, arrays, findings, nearCoordinates(arrays),
            [&](const In& in, const glm::vec4& actual, const glm::vec4& expected) {
                const TextureRecord& record = arrays.textures[in.texture];
                const glm::dvec2 p = texelPosition(record, in.uv), edge = glm::abs(p - glm::round(p));
                const double shift = shiftOf(in, p);
                const bool nearest = (record.flags & kTextureNearest) != 0;
                if (nearest && std::min(edge.x, edge.y) < shift) return;  // either texel will do
                findings.near(nearest ? "nearest" : "bilinear", actual, expected, 1e-6 + 2 * shift, 4e-6);
            });
    forEach(scene, arrays, findings, farCoordinates(arrays),
            [&](const In&, const glm::vec4& actual, const glm::vec4& expected) {
                findings.near("far outside", actual, expected, 1e-6, 4e-6);
            });
}

}  // namespace vkpt
