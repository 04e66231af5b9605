// A BSDF as users write it: VKPT_materials_bsdf in a glTF file, --material and `vkpt bsdf` on the command line.
#pragma once
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "layout.h"
#include "registry.h"

namespace vkpt {

enum class Distribution : std::uint32_t {
    Ggx = kDistributionGgx,
    Beckmann = kDistributionBeckmann,
    Phong = kDistributionPhong,
};

enum class Masking : std::uint32_t {
    Correlated = kMaskingCorrelated,
    Separable = kMaskingSeparable,
    VGroove = kMaskingVGroove,
};

/// Parameters of one model; those that a model does not read keep their defaults. Colours are linear Rec. 709.
struct BsdfSpec {
    BsdfId model = BsdfId::Gltf;
    glm::vec3 color{1};
    glm::vec3 diffuse{0};
    glm::vec2 alpha{0};  ///< never squared; along tangent and bitangent
    Distribution distribution = Distribution::Ggx;
    Masking masking = Masking::Correlated;
    bool metal = false;         ///< Fresnel term of a conductor
    glm::vec3 eta{1.5F}, k{0};  ///< index of refraction, its imaginary part
    glm::vec2 exponent{0};
    bool conserving = true;         ///< blinn_phong's normalization
    float sigma = 0;                ///< oren_nayar: radians; eon: roughness
    float specular = 1;             ///< cook_torrance: share of the specular part
    float weight = 1;               ///< cook_torrance: share of the distribution with alpha.x
    glm::vec3 attenuationColor{1};  ///< dielectric: what is left of white light after attenuationDistance inside
    float attenuationDistance = 1;  ///< metres
    float metallic = 0;             ///< gltf, with color and sigma (perceptual roughness)

    bool operator==(const BsdfSpec&) const = default;
};

/// What a bare name stands for.
[[nodiscard]] BsdfSpec defaultBsdf(BsdfId model);

/// Its x axis matters.
[[nodiscard]] bool isAnisotropic(const BsdfSpec& spec);

/// From the keys of VKPT_materials_bsdf. Throws std::invalid_argument, whose text names the field, its value and what
/// it may be.
[[nodiscard]] BsdfSpec bsdfFromJson(const nlohmann::ordered_json& json);

/// SPEC = model[:key=value,…] | JSON | @FILE. The parts of a vector are separated by slashes: `alpha=0.1/0.3`.
/// Throws std::invalid_argument as above, FileError for a file that cannot be read.
[[nodiscard]] BsdfSpec parseBsdfSpec(std::string_view text);

/// With the default of every key filled in, for reports.
[[nodiscard]] nlohmann::ordered_json bsdfToJson(const BsdfSpec& spec);

/// Every model, its keys and their defaults, a line each, for --help and README.
[[nodiscard]] std::string bsdfHelp();

/// As both renderers read it; without an albedo table yet (albedo_tables.h).
[[nodiscard]] BsdfRecord bsdfRecord(const BsdfSpec& spec);

}  // namespace vkpt
