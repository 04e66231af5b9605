#include "scene/bsdf_spec.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/json.h"
#include "scene/json_values.h"
#include "scene/metals.h"

namespace vkpt {
namespace {

using Models = std::uint32_t;  ///< a bit a model

template <class... Id>
constexpr Models models(Id... id) {
    return ((1U << static_cast<std::uint32_t>(id)) | ...);
}

constexpr auto kDistributions = std::to_array<Choice<Distribution>>(
    {{"ggx", Distribution::Ggx}, {"beckmann", Distribution::Beckmann}, {"phong", Distribution::Phong}});
constexpr auto kMaskings =
    std::to_array<Choice<Masking>>({{"smith", Masking::Correlated}, {"smith_separable", Masking::Separable}});
constexpr auto kNormalizations = std::to_array<Choice<bool>>({{"conserving", true}, {"lecture", false}});
constexpr auto kIors = std::to_array<Choice<float>>({{"water", 1.333F}, {"glass", 1.5F}, {"diamond", 2.417F}});

void readMetal(BsdfSpec& spec, const Json& value) {
    for (const Metal& metal : kMetals) {
        if (!value.is_string() || metal.symbol != value.get<std::string>()) continue;
        spec.metal = true;
        spec.eta = metal.eta;
        spec.k = metal.k;
        return;
    }
    refuse("metal", value, "one of Cu, Fe, Au, Ag, Al, Hg");
}

void readIor(BsdfSpec& spec, const Json& value) {
    spec.metal = false;
    spec.eta = glm::vec3(value.is_string() ? choose("ior", value, kIors) : number("ior", value, 1.01, 10));
    spec.k = glm::vec3(0);
}

/// The two materials of [Cook 81]: copper (figs. 7 and 8) and copper-coloured plastic (fig. 6).
void readPreset(BsdfSpec& spec, const Json& value) {
    constexpr glm::vec3 kCopperColor(0.955F, 0.638F, 0.538F);
    if (value == "copper") {
        readMetal(spec, "Cu");
        spec.specular = 1;
        spec.alpha = {0.4F, 0.2F};
        spec.weight = 0.4F;
    } else if (value == "copper_plastic") {
        readIor(spec, 1.5);
        spec.specular = 0.1F;
        spec.diffuse = kCopperColor;
        spec.alpha = glm::vec2(0.15F);
        spec.weight = 1;
    } else {
        refuse("preset", value, "one of copper, copper_plastic");
    }
}

constexpr Models kDiffuseModels =
    models(BsdfId::Phong, BsdfId::BlinnPhong, BsdfId::Plastic, BsdfId::CookTorrance, BsdfId::AshikhminShirley);
constexpr Models kFacetModels =
    models(BsdfId::Conductor, BsdfId::Dielectric, BsdfId::Plastic, BsdfId::TorranceSparrow, BsdfId::CookTorrance);
constexpr Models kMetalModels = models(BsdfId::Conductor, BsdfId::TorranceSparrow, BsdfId::CookTorrance);
constexpr Models kIorModels =
    models(BsdfId::Dielectric, BsdfId::Plastic, BsdfId::TorranceSparrow, BsdfId::CookTorrance);

struct Key {
    std::string_view name;
    Models models;
    void (*read)(BsdfSpec& spec, const Json& value);
};

/// In the order in which they are read: a later one overrides what an earlier one implies.
const std::array kKeys = {
    Key{"preset", models(BsdfId::CookTorrance), readPreset},
    Key{"color", ~models(BsdfId::Plastic), [](BsdfSpec& s, const Json& v) { s.color = three("color", v, 0, 1); }},
    Key{"diffuse", kDiffuseModels, [](BsdfSpec& s, const Json& v) { s.diffuse = three("diffuse", v, 0, 1); }},
    Key{"alpha", kFacetModels, [](BsdfSpec& s, const Json& v) { s.alpha = two("alpha", v, 0, 1); }},
    Key{"distribution", kFacetModels,
        [](BsdfSpec& s, const Json& v) { s.distribution = choose("distribution", v, kDistributions); }},
    Key{"masking", models(BsdfId::Conductor, BsdfId::Dielectric, BsdfId::Plastic),
        [](BsdfSpec& s, const Json& v) { s.masking = choose("masking", v, kMaskings); }},
    Key{"metal", kMetalModels, readMetal},
    Key{"eta", kMetalModels,
        [](BsdfSpec& s, const Json& v) {
            s.metal = true;
            s.eta = three("eta", v, 0.01, 20);
        }},
    Key{"k", kMetalModels,
        [](BsdfSpec& s, const Json& v) {
            s.metal = true;
            s.k = three("k", v, 0, 20);
        }},
    Key{"ior", kIorModels, readIor},
    Key{"exponent", models(BsdfId::Phong, BsdfId::BlinnPhong, BsdfId::AshikhminShirley),
        [](BsdfSpec& s, const Json& v) {
            s.exponent = s.model == BsdfId::AshikhminShirley ? two("exponent", v, 0, 1e5)
                                                             : glm::vec2(number("exponent", v, 0, 1e5));
        }},
    Key{"normalization", models(BsdfId::BlinnPhong),
        [](BsdfSpec& s, const Json& v) { s.conserving = choose("normalization", v, kNormalizations); }},
    Key{"sigma", models(BsdfId::OrenNayar),
        [](BsdfSpec& s, const Json& v) { s.sigma = number("sigma", v, 0, std::numbers::pi / 2); }},
    Key{"roughness", models(BsdfId::Eon, BsdfId::Gltf),
        [](BsdfSpec& s, const Json& v) { s.sigma = number("roughness", v, 0, 1); }},
    Key{"metallic", models(BsdfId::Gltf), [](BsdfSpec& s, const Json& v) { s.metallic = number("metallic", v, 0, 1); }},
    Key{"specular", models(BsdfId::CookTorrance),
        [](BsdfSpec& s, const Json& v) { s.specular = number("specular", v, 0, 1); }},
    Key{"weight", models(BsdfId::CookTorrance),
        [](BsdfSpec& s, const Json& v) { s.weight = number("weight", v, 0, 1); }},
    Key{"attenuation_color", models(BsdfId::Dielectric),
        [](BsdfSpec& s, const Json& v) { s.attenuationColor = three("attenuation_color", v, 1e-6, 1); }},
    Key{"attenuation_distance", models(BsdfId::Dielectric),
        [](BsdfSpec& s, const Json& v) { s.attenuationDistance = number("attenuation_distance", v, 1e-6, 1e6); }},
};

bool reads(const Key& key, BsdfId model) { return (key.models & models(model)) != 0; }

std::string keysOf(BsdfId model) {
    std::vector<std::string_view> names;
    for (const Key& key : kKeys)
        if (reads(key, model)) names.push_back(key.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

BsdfId modelOf(const Json& value) {
    std::vector<std::string_view> names;
    for (const BsdfModelInfo& info : kBsdfModels) {
        if (value.is_string() && value.get<std::string>() == info.name) return info.id;
        names.push_back(info.name);
    }
    refuse("model", value, fmt::format("one of {}", fmt::join(names, ", ")));
}

void refuseContradictions(const Json& json) {
    const bool metal = json.contains("metal"), complex = json.contains("eta") || json.contains("k");
    if (metal + complex + json.contains("ior") > 1)
        throw std::invalid_argument("metal, ior, and eta with k: give one of the three");
    if (json.contains("eta") != json.contains("k")) throw std::invalid_argument("eta, k: a metal needs both");
}

Json colorJson(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

BsdfSpec defaultBsdf(BsdfId model) {
    BsdfSpec spec;
    spec.model = model;
    switch (model) {
        case BsdfId::Gltf:
            spec.sigma = 0.5F;
            break;
        case BsdfId::Lambert:
            spec.color = glm::vec3(0.8F);
            break;
        case BsdfId::OrenNayar:
        case BsdfId::Eon:
            spec.color = glm::vec3(0.8F);
            spec.sigma = 0.5F;
            break;
        case BsdfId::Phong:
        case BsdfId::BlinnPhong:
            spec.color = glm::vec3(0.5F);
            spec.exponent = glm::vec2(50);
            break;
        case BsdfId::Conductor:
            readMetal(spec, "Cu");
            spec.alpha = glm::vec2(0.2F);
            break;
        case BsdfId::Plastic:
            spec.diffuse = glm::vec3(0.5F);
            spec.alpha = glm::vec2(0.1F);
            break;
        case BsdfId::TorranceSparrow:
            readMetal(spec, "Cu");
            spec.alpha = glm::vec2(0.2F);
            spec.distribution = Distribution::Beckmann;
            spec.masking = Masking::VGroove;
            break;
        case BsdfId::CookTorrance:
            readPreset(spec, "copper");
            spec.distribution = Distribution::Beckmann;
            spec.masking = Masking::VGroove;
            break;
        case BsdfId::AshikhminShirley:
            spec.color = glm::vec3(0.1F);
            spec.diffuse = glm::vec3(0.5F);
            spec.exponent = {10, 1000};
            break;
        case BsdfId::Mirror:
        case BsdfId::Dielectric:
            break;
    }
    return spec;
}

BsdfSpec bsdfFromJson(const Json& json) {
    if (!json.is_object() || !json.contains("model")) throw std::invalid_argument("model: is missing");
    const BsdfId model = modelOf(json["model"]);
    for (const auto& item : json.items()) {
        const auto isThis = [&](const Key& key) { return key.name == item.key() && reads(key, model); };
        if (item.key() != "model" && std::ranges::none_of(kKeys, isThis))
            throw std::invalid_argument(fmt::format("{}: is no key of {}; its keys are {}", item.key(),
                                                    kBsdfModels[static_cast<std::size_t>(model)].name, keysOf(model)));
    }
    refuseContradictions(json);
    BsdfSpec spec = defaultBsdf(model);
    for (const Key& key : kKeys) {
        const auto value = json.find(key.name);
        if (value != json.end()) key.read(spec, *value);
    }
    return spec;
}

Json bsdfToJson(const BsdfSpec& spec) {
    Json json{{"model", std::string(kBsdfModels[static_cast<std::size_t>(spec.model)].name)}};
    const auto put = [&](std::string_view name, const Json& value) {
        const auto isThis = [&](const Key& key) { return key.name == name && reads(key, spec.model); };
        if (std::ranges::any_of(kKeys, isThis)) json[std::string(name)] = value;
    };
    put("color", colorJson(spec.color));
    put("diffuse", colorJson(spec.diffuse));
    put("alpha", Json::array({spec.alpha.x, spec.alpha.y}));
    put("distribution", nameOf(kDistributions, spec.distribution));
    put("masking", spec.masking == Masking::VGroove ? "v_groove" : nameOf(kMaskings, spec.masking));
    if (spec.metal) {
        put("eta", colorJson(spec.eta));
        put("k", colorJson(spec.k));
    } else {
        put("ior", spec.eta.x);
    }
    put("exponent", spec.model == BsdfId::AshikhminShirley ? Json::array({spec.exponent.x, spec.exponent.y})
                                                           : Json(spec.exponent.x));
    put("normalization", nameOf(kNormalizations, spec.conserving));
    put("sigma", spec.sigma);
    put("roughness", spec.sigma);
    put("metallic", spec.metallic);
    put("specular", spec.specular);
    put("weight", spec.weight);
    put("attenuation_color", colorJson(spec.attenuationColor));
    put("attenuation_distance", spec.attenuationDistance);
    return json;
}

std::string bsdfHelp() {
    std::string text;
    for (const BsdfModelInfo& info : kBsdfModels)
        text += fmt::format("{:<18}{}: {}\n", info.name, info.help, keysOf(info.id));
    return text;
}

}  // namespace vkpt
