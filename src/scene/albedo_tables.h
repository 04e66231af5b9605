// Directional albedos of rough interfaces, in the cells that both renderers look up: estimator.md, Albedo tables.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene/bsdf_spec.h"

namespace vkpt {

/// What one table is of.
struct AlbedoTableKey {
    Distribution distribution = Distribution::Ggx;
    Masking masking = Masking::Correlated;
    float eta = 0;                   ///< 0: a conductor; else ior of the far side over that of the near side
    std::optional<glm::vec2> alpha{};  ///< rows are azimuths at this roughness; none: rows are isotropic roughnesses

    bool operator==(const AlbedoTableKey&) const = default;
};

/// kAlbedoTableWords cells, by quadrature: about 0.2 s on two cores.
[[nodiscard]] std::vector<AlbedoCell> makeAlbedoTable(const AlbedoTableKey& key);

/// The table of glTF's facets (GGX, height-correlated), made at build time.
[[nodiscard]] std::span<const AlbedoCell> gltfAlbedoTable();

/// Gathers the tables of a scene's materials, each once.
class AlbedoTables {
public:
    /// `multiscatter`: begins with glTF's, and conductors and dielectrics get theirs; else only what the models
    /// themselves are made of (plastic).
    explicit AlbedoTables(bool multiscatter);

    /// Sets `record.table` and kBsdfAzimuthTable. `texturedAlpha`: the roughness varies over the surface; then an
    /// anisotropic one is looked up at its geometric mean.
    void add(BsdfId model, bool texturedAlpha, BsdfRecord& record);

    [[nodiscard]] std::vector<AlbedoCell> take() { return std::move(cells_); }

private:
    std::uint32_t find(const std::vector<AlbedoTableKey>& keys);

    bool multiscatter_;
    std::vector<std::vector<AlbedoTableKey>> made_;
    std::vector<std::uint32_t> first_;
    std::vector<AlbedoCell> cells_;
};

}  // namespace vkpt
