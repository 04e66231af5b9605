// The surface that one segment met: steps 3 to 7 of estimator.md there.
#pragma once
#include "reference/frame.h"
#include "reference/heuristic.h"
#include "reference/light.h"
#include "reference/path_state.h"

namespace vkpt::reference {

/// What surfaces read of a render.
struct Transport {
    const SceneArrays& scene;
    const RenderParams& params;
    Lights lights;
    Heuristic heuristic;

    Transport(const SceneArrays& sceneArrays, const RenderParams& renderParams)
        : scene(sceneArrays), params(renderParams), lights(sceneArrays), heuristic(renderParams) {}

    /// Scales what indirect light adds to at most params.clampIndirect. `scatterings`: how many there were.
    [[nodiscard]] glm::vec3 clamped(const glm::vec3& contribution, std::uint32_t scatterings) const;
    [[nodiscard]] bool hasLens() const { return params.lensRadius > 0 && params.projection != kProjectionPanorama; }
    /// Dimension of one use (kDimLight, ...) of the numbers of a bounce.
    [[nodiscard]] std::uint32_t dimension(std::uint32_t bounce, std::uint32_t use) const;
};

class Surface {
public:
    /// All arguments must outlive this.
    Surface(const Transport& transport, const PathState& state, const Hit& hit);

    /// Steps 3 to 7.
    [[nodiscard]] PathVertex shade() const;

    /// A light sample that meets the surface where it reflects or transmits.
    struct LightPath {
        LightSample light;
        glm::vec3 wi{0};    ///< local
        glm::vec3 f{0};     ///< not black, like light.radiance
        float pdfBsdf = 0;  ///< of wi
    };
    /// Step 5 up to the light: nothing where none, or where no light would come that way.
    [[nodiscard]] std::optional<LightPath> findLight() const;

    [[nodiscard]] const ShadingPoint& point() const { return point_; }
    [[nodiscard]] const Attributes& attributes() const { return attributes_; }
    [[nodiscard]] const MaterialRecord& material() const { return material_; }
    [[nodiscard]] std::uint32_t materialIndex() const { return triangle_.flags >> kTriangleMaterialShift; }
    [[nodiscard]] bool isUnlit() const { return (material_.flags & kMaterialUnlit) != 0; }

private:
    [[nodiscard]] std::uint32_t dimension(std::uint32_t use) const;
    [[nodiscard]] bool drawsHemisphere() const;
    [[nodiscard]] float pdf(const glm::vec3& wi) const;
    [[nodiscard]] bool isConsistent(const glm::vec3& wiLocal, const glm::vec3& wiWorld) const;
    [[nodiscard]] const glm::vec3& originTowards(const glm::vec3& wiLocal) const;
    [[nodiscard]] std::uint32_t mediumTowards(const glm::vec3& wiLocal) const;

    [[nodiscard]] glm::vec3 emitted() const;
    [[nodiscard]] std::optional<DirectLight> sampleLight() const;
    [[nodiscard]] BsdfSample<float> draw() const;
    [[nodiscard]] std::optional<PathState> scatter() const;
    [[nodiscard]] bool survives(PathState& next) const;

    const Transport& transport_;
    const SceneArrays& scene_;
    const RenderParams& params_;
    const PathState& state_;
    const Hit& hit_;
    const TriangleRecord& triangle_;
    const MaterialRecord& material_;
    glm::vec3 throughput_;  ///< of the path at the surface
    Attributes attributes_;
    glm::vec3 woWorld_;
    ShadingPoint point_;
    Frame<float> frame_;
    glm::vec3 wo_;  ///< local
    Bsdf<float> bsdf_;
};

}  // namespace vkpt::reference
