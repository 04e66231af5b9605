// The maps of a material, read set by set, against each texture read by itself.
#include <algorithm>
#include <bit>

#include "reference/texture.h"
#include "scene/flatten.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec4 uv;
    std::uint32_t material, unused[3] = {};
};
struct Out {
    glm::vec4 maps[kMapRoles];
};

TextureUse randomUse(RandomInputs& random, int images) {
    constexpr Wrap kWraps[] = {Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat};
    TextureUse use;
    use.image = static_cast<int>(random.below(static_cast<std::uint32_t>(images)));
    if (random.below(16) == 0) use.wrapS = kWraps[random.below(3)];
    if (random.below(16) == 0) use.uvSet = 1;
    if (random.below(16) == 0) use.rowU = {1.5F, 0.5F, 0.25F};
    return use;
}

/// Materials with every subset of the four maps, four times each: of one size or several, alike or not, with images
/// that several share.
Scene makeScene() {
    Scene scene;
    scene.path = "memory.gltf";
    RandomInputs random(31);
    for (std::uint32_t i = 0; i < 300; ++i) {
        const glm::uvec2 size = i % 10 == 0 ? glm::uvec2(5, 3) : glm::uvec2(8, 8);
        TextureImage image{"image", size.x, size.y, std::vector<std::uint32_t>(std::size_t{size.x} * size.y)};
        for (std::uint32_t& texel : image.texels) texel = random.bits();
        scene.images.push_back(std::move(image));
    }
    scene.meshes.resize(1);
    for (std::uint32_t i = 0; i < 64; ++i) {
        Material material;
        material.emissive = glm::vec3(1);
        TextureUse* const slots[] = {&material.baseColorTexture, &material.metallicRoughnessTexture,
                                     &material.normalTexture, &material.emissiveTexture};
        for (std::uint32_t role = 0; role < kMapRoles; ++role)
            if ((i >> role & 1U) != 0) *slots[role] = randomUse(random, static_cast<int>(scene.images.size()));
        scene.materials.push_back(material);
        Primitive p;
        p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        p.normals.assign(3, {0, 0, 1});
        p.triangles = {{0, 1, 2}};
        p.material = i;
        scene.meshes[0].primitives.push_back(p);
    }
    scene.instances.push_back({"node", 0, glm::mat4(1)});
    return scene;
}

std::vector<In> pointsOnEach(const SceneArrays& arrays) {
    std::vector<In> inputs;
    RandomInputs random(32);
    const auto coordinate = [&] { return random.between(-2, 3); };
    for (std::uint32_t m = 0; m < arrays.materials.size(); ++m)
        for (int i = 0; i < 16; ++i) inputs.push_back({{coordinate(), coordinate(), coordinate(), coordinate()}, m});
    return inputs;
}

/// Materials whose first set holds several maps.
std::size_t interleaved(const SceneArrays& arrays) {
    return static_cast<std::size_t>(std::ranges::count_if(arrays.materials, [](const MaterialRecord& m) {
        return std::popcount(m.flags >> kMaterialMapSetShift & ((1U << kMapRoles) - 1)) > 1;
    }));
}

glm::vec4 readAlone(const SceneArrays& arrays, std::uint32_t texture, const glm::vec4& uv, const glm::vec4& absent) {
    if (texture == kNone) return absent;
    return reference::sampleTexture(arrays, texture, {{uv.x, uv.y}, {uv.z, uv.w}});
}

}  // namespace

void checkMaps(VerifyContext& context, Findings& findings) {
    const SceneArrays arrays = flatten(makeScene());
    const std::vector<In> inputs = pointsOnEach(arrays);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("sampleMaterialMaps of material {} at {}", inputs[i].material, show(inputs[i].uv));
    });
    findings.holds("inputs", interleaved(arrays) >= 16, "too few materials have maps that are read together");
    const auto out = ProbeScene(context.prober(), arrays).evaluate<Out>(findings, "maps", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const MaterialRecord& m = arrays.materials[inputs[i].material];
        const std::array textures = {m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture,
                                     m.emissiveTexture};
        for (std::uint32_t role = 0; role < kMapRoles; ++role) {
            const glm::vec4 absent = role == kMapNormal ? glm::vec4(0.5F, 0.5F, 1, 1) : glm::vec4(1);
            findings.near(fmt::format("map {}", role), out[i].maps[role],
                          readAlone(arrays, textures[role], inputs[i].uv, absent), 2e-5);
        }
    }
}

}  // namespace vkpt
