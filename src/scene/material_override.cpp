#include "scene/material_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "base/error.h"

namespace vkpt {
namespace {

BsdfSpec specOf(const char* option, const std::string& text) {
    try {
        return parseBsdfSpec(text);
    } catch (const std::invalid_argument& fault) {
        throw Error(ExitCode::Usage, printable(fmt::format("{} {}: {}", option, text, fault.what())));
    }
}

/// By name; else by index.
Material* find(std::vector<Material>& materials, const std::string& key) {
    const auto named = std::ranges::find(materials, key, &Material::name);
    if (named != materials.end()) return &*named;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (error != std::errc{} || end != key.data() + key.size() || index >= materials.size()) return nullptr;
    return &materials[index];
}

std::string namesOf(const std::vector<Material>& materials) {
    constexpr std::size_t kMost = 20;
    std::string names;
    for (std::size_t i = 0; i < std::min(materials.size(), kMost); ++i)
        names += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, materials[i].name);
    return materials.size() > kMost ? names + ", …" : names;
}

}  // namespace

void setBsdf(Material& material, const BsdfSpec& spec) {
    material.unlit = false;
    material.bsdf.reset();
    if (spec.model != BsdfId::Gltf) {
        material.bsdf = spec;
        return;
    }
    material.baseColor = glm::vec4(spec.color, material.baseColor.a);
    material.metallic = spec.metallic;
    material.roughness = spec.sigma;
}

void overrideMaterial(std::vector<Material>& materials, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw Error(ExitCode::Usage, printable(fmt::format("--material: '{}' is not NAME=SPEC", text)));
    Material* material = find(materials, text.substr(0, equals));
    if (material == nullptr)
        throw Error(ExitCode::Usage, printable(fmt::format("--material {}: the scene has no such material; it has {}",
                                                           text.substr(0, equals), namesOf(materials))));
    setBsdf(*material, specOf("--material", text.substr(equals + 1)));
}

void overrideMaterials(std::vector<Material>& materials, const std::string& text) {
    const BsdfSpec spec = specOf("--material-all", text);
    for (Material& material : materials) setBsdf(material, spec);
}

}  // namespace vkpt
