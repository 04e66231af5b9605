#include "reference/path.h"

#include "dimensions.h"
#include "reference/accumulate.h"
#include "reference/camera.h"
#include "reference/frame.h"
#include "reference/layers.h"
#include "reference/traverse.h"
#include "reference/warp.h"

namespace vkpt::reference {

namespace {

/// Power heuristic, beta = 2, of two densities. [Veach 97, sec. 9.2] An infinite `mine` has weight 1.
float powerHeuristic(float mine, float other) {
    if (std::isinf(mine)) return 1;
    const float ratio = other / mine;  // squares of the densities would overflow
    return 1 / (1 + ratio * ratio);
}

/// The surface that one segment met, and the steps of estimator.md there.
class Surface {
public:
    Surface(const SceneArrays& scene, const RenderParams& params, const Lights& lights, const PathState& state,
            const Hit& hit)
        : scene_(scene),
          params_(params),
          lights_(lights),
          state_(state),
          hit_(hit),
          triangle_(scene.triangles[hit.triangle]),
          material_(materialOf(scene, triangle_)),
          attributes_(interpolateAttributes(scene, triangle_, hit.barycentrics)),
          wo_(-state.ray.direction),
          point_(makeShadingPoint(scene, hit, attributes_, wo_)) {}

    [[nodiscard]] PathVertex shade() const {
        PathVertex vertex;
        vertex.point = point_;
        vertex.material = triangle_.flags >> kTriangleMaterialShift;
        vertex.emitted = emitted();                                         // 3
        if (isUnlit() || state_.bounce == params_.maxDepth) return vertex;  // 4
        const Scattering at = prepare();
        vertex.direct = sampleLight(at);                               // 5
        vertex.next = scatter(at);                                     // 6
        if (vertex.next && !survives(*vertex.next)) vertex.next = {};  // 7
        return vertex;
    }

private:
    struct Scattering {
        Frame<float> frame;
        Bsdf<float> bsdf;
        glm::vec3 wo;  ///< local
    };

    [[nodiscard]] bool isUnlit() const { return (material_.flags & kMaterialUnlit) != 0; }
    [[nodiscard]] std::uint32_t dimension(std::uint32_t use) const {
        return kDimBounce + state_.bounce * kDimBounceStride + use;
    }

    [[nodiscard]] glm::vec3 emitted() const {
        if (isUnlit()) return state_.throughput * glm::vec3(baseColor(scene_, material_, attributes_));
        if (!point_.front && (material_.flags & kMaterialDoubleSided) == 0) return glm::vec3(0);
        const glm::vec3 le = emission(scene_, material_, attributes_);
        if (isBlack(le)) return le;
        float w = 1;
        if (triangle_.light != kNone) {
            const LightRecord& light = scene_.lights[triangle_.light];
            w = powerHeuristic(state_.pdfBsdf, lights_.pdfTriangle(light, state_.ray.direction, hit_.t));
        }
        return state_.throughput * le * w;
    }

    [[nodiscard]] Scattering prepare() const {
        const bool anisotropic = modelOf(material_) != BsdfId::Gltf;
        const Frame<float> frame = anisotropic ? Frame<float>(point_.ns, point_.tangent) : Frame<float>(point_.ns);
        return {frame, bsdfOf(scene_, triangle_, attributes_, point_.front), frame.toLocal(wo_)};
    }

    /// Whether the surface itself lets light pass from wo to wi: both normals agree on the side of wi.
    [[nodiscard]] bool isConsistent(const glm::vec3& wiLocal, const glm::vec3& wiWorld) const {
        const float side = glm::dot(wiWorld, point_.ng);
        return wiLocal.z > 0 ? side > 0 : side < 0;
    }
    [[nodiscard]] const glm::vec3& originTowards(const glm::vec3& wiLocal) const {
        return wiLocal.z > 0 ? point_.rayOrigin : point_.farOrigin;
    }

    /// Next event estimation.
    [[nodiscard]] std::optional<DirectLight> sampleLight(const Scattering& at) const {
        if (lights_.empty() || !hasDensity(at.bsdf, at.wo)) return std::nullopt;
        const auto light = lights_.sample(point_.position, state_.sample.bits2D(dimension(kDimLight)));
        if (!light) return std::nullopt;
        const glm::vec3 wi = at.frame.toLocal(light->wi);
        if (!isConsistent(wi, light->wi)) return std::nullopt;
        const glm::vec3 f = evalBsdf(at.bsdf, at.wo, wi);
        const float w = light->punctual ? 1 : powerHeuristic(light->pdf, pdfBsdf(at.bsdf, at.wo, wi));
        DirectLight direct;
        direct.contribution = state_.throughput * f * std::abs(wi.z) * light->radiance / light->pdf * w;
        if (isBlack(direct.contribution)) return std::nullopt;
        const glm::vec3& origin = originTowards(wi);
        direct.shadowRay = {origin, light->infinite ? light->wi : light->end - origin};
        if (light->infinite) direct.tMax = std::numeric_limits<float>::infinity();
        return direct;
    }

    /// Draws the next ray; nothing where the path ends.
    [[nodiscard]] std::optional<PathState> scatter(const Scattering& at) const {
        const PathSample& sample = state_.sample;
        const Vec2<float> u = sample.get2D(dimension(kDimBsdf));
        const bool onePair = modelOf(material_) == BsdfId::Gltf;
        const auto drawn =
            onePair ? sampleBsdf(at.bsdf, at.wo, u.x, {gltfAfterChoices(at.bsdf, at.wo, u.x), u.y})
                    : sampleBsdf(at.bsdf, at.wo, sample.get1D(dimension(kDimLobe)), u);
        const glm::vec3 wi = at.frame.toWorld(drawn.wi);
        if (isBlack(drawn.weight) || !isConsistent(drawn.wi, wi)) return std::nullopt;
        const glm::vec3 throughput = state_.throughput * drawn.weight;
        if (isBlack(throughput)) return std::nullopt;
        return PathState{sample, state_.bounce + 1, {originTowards(drawn.wi), wi}, throughput, drawn.pdf};
    }

    /// Russian roulette.
    [[nodiscard]] bool survives(PathState& next) const {
        if (params_.rrMode == kRouletteOff || state_.bounce + 1 < params_.rrDepth) return true;
        glm::vec3& throughput = next.throughput;
        const float q = params_.rrMode == kRouletteFixed
                            ? params_.rrFixed
                            : std::min(1.0F, std::max({throughput.x, throughput.y, throughput.z}));
        if (!(state_.sample.get1D(dimension(kDimRoulette)) < q)) return false;
        throughput /= q;
        return true;
    }

    const SceneArrays& scene_;
    const RenderParams& params_;
    const Lights& lights_;
    const PathState& state_;
    const Hit& hit_;
    const TriangleRecord& triangle_;
    const MaterialRecord& material_;
    Attributes attributes_;
    glm::vec3 wo_;
    ShadingPoint point_;
};

void add(PathTally& tally, const glm::vec3& contribution) {
    if (isBlack(contribution)) return;
    if (!addContribution(tally.sums, contribution)) ++tally.refused;
}

}  // namespace

PathTracer::PathTracer(const SceneArrays& scene, const RenderOptions& options)
    : scene_(scene), params_(options.params), lights_(scene), bits_(samplerBits(options.sampler)) {}

PathState PathTracer::start(std::uint32_t x, std::uint32_t y, std::uint32_t index) const {
    PathState state;
    state.sample = sampleOf(x, y, index);
    state.ray = cameraRay(params_, glm::vec2(x, y) + state.sample.get2D(kDimFilter));
    return state;
}

std::optional<Hit> PathTracer::intersect(const PathState& state) const {
    return closestHit(scene_, state.ray, alphaKey(state.sample.id, state.bounce, kRayPath));
}

glm::vec3 PathTracer::miss(const PathState& state) const {
    const glm::vec3& d = state.ray.direction;
    if (state.bounce > 0) {
        const float w = powerHeuristic(state.pdfBsdf, lights_.pdfEnvironment(d));
        return state.throughput * lights_.environment().radiance(d) * w;
    }
    if (params_.backgroundMode == kBackgroundTransparent) return glm::vec3(0);
    return params_.backgroundMode == kBackgroundColor ? params_.background : lights_.environment().radiance(d);
}

PathVertex PathTracer::shade(const PathState& state, const Hit& hit) const {
    return Surface(scene_, params_, lights_, state, hit).shade();
}

bool PathTracer::isOccluded(const PathState& state, const DirectLight& direct) const {
    return anyHit(scene_, direct.shadowRay, direct.tMax, alphaKey(state.sample.id, state.bounce, kRayShadow));
}

void PathTracer::countCameraRay(PathTally& tally, const PathState& camera, const std::optional<Hit>& hit) const {
    if (hit || params_.backgroundMode != kBackgroundTransparent) ++tally.sums.red.w;
    if (hit) ++tally.sums.green.w;
    if (tally.layers != nullptr) tally.layers->addFirstHit(camera.ray, hit);
}

void PathTracer::trace(std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally) const {
    std::optional<PathState> state = start(x, y, index);
    while (state) {
        ++tally.pathRays;
        const auto hit = intersect(*state);  // 1
        if (state->bounce == 0) countCameraRay(tally, *state, hit);
        if (!hit) return add(tally, miss(*state));  // 2
        const PathVertex vertex = shade(*state, *hit);
        add(tally, vertex.emitted);
        if (vertex.direct) {
            ++tally.shadowRays;
            if (!isOccluded(*state, *vertex.direct)) add(tally, vertex.direct->contribution);
        }
        state = vertex.next;
    }
}

}  // namespace vkpt::reference
