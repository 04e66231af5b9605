#include "reference/path.h"

#include "dimensions.h"
#include "reference/accumulate.h"
#include "reference/bsdf.h"
#include "reference/camera.h"
#include "reference/frame.h"
#include "reference/geometry.h"
#include "reference/traverse.h"

namespace vkpt::reference {

namespace {

/// Power heuristic, beta = 2, of two densities. [Veach 97, sec. 9.2] An infinite `mine` has weight 1.
float powerHeuristic(float mine, float other) {
    if (std::isinf(mine)) return 1;
    const float ratio = other / mine;  // squares of the densities would overflow
    return 1 / (1 + ratio * ratio);
}

}  // namespace

/// The state of one path, and the steps of estimator.md under their numbers.
class Path {
public:
    Path(const PathTracer& tracer, std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally)
        : scene_(tracer.scene_),
          params_(tracer.params_),
          lights_(tracer.lights_),
          sample_{tracer.bits_, {x | y << 16U, index, tracer.params_.spp, tracer.params_.seed}},
          tally_(tally) {
        ray_ = cameraRay(params_, glm::vec2(x, y) + sample_.get2D(kDimFilter));
    }

    void trace() {
        for (bounce_ = 0;; ++bounce_) {
            const auto hit = intersect();  // 1
            if (!hit) return addMiss();    // 2
            if (bounce_ == 0) tally_.sums.red.w += 1;
            const Surface surface = meet(*hit);
            addEmission(*hit, surface);                                    // 3
            if (surface.isUnlit() || bounce_ == params_.maxDepth) return;  // 4
            const Scattering scattering = prepare(surface);
            addLight(scattering);                             // 5
            if (!scatter(scattering) || !survives()) return;  // 6, 7
        }
    }

private:
    struct Surface {
        const TriangleRecord& triangle;
        const MaterialRecord& material;
        Attributes attributes;
        ShadingPoint point;
        glm::vec3 wo;

        [[nodiscard]] bool isUnlit() const { return (material.flags & kMaterialUnlit) != 0; }
    };

    struct Scattering {
        ShadingPoint point;
        Frame<float> frame;
        Bsdf<float> bsdf;
        glm::vec3 wo;  ///< local
    };

    [[nodiscard]] std::uint32_t dimension(std::uint32_t use) const {
        return kDimBounce + bounce_ * kDimBounceStride + use;
    }

    void add(const glm::vec3& contribution) {
        if (isBlack(contribution)) return;
        if (!addContribution(tally_.sums, contribution)) ++tally_.refused;
    }

    std::optional<Hit> intersect() {
        ++tally_.pathRays;
        return closestHit(scene_, ray_, alphaKey(sample_.id, bounce_, kRayPath));
    }

    void addMiss() {
        if (bounce_ > 0) {
            const float w = powerHeuristic(pdfBsdf_, lights_.pdfEnvironment(ray_.direction));
            return add(throughput_ * lights_.environment().radiance(ray_.direction) * w);
        }
        if (params_.backgroundMode == kBackgroundTransparent) return;
        tally_.sums.red.w += 1;
        add(params_.backgroundMode == kBackgroundColor ? params_.background
                                                       : lights_.environment().radiance(ray_.direction));
    }

    [[nodiscard]] Surface meet(const Hit& hit) const {
        const TriangleRecord& triangle = scene_.triangles[hit.triangle];
        const Attributes attributes = interpolateAttributes(scene_, triangle, hit.barycentrics);
        const glm::vec3 wo = -ray_.direction;
        return {triangle, materialOf(scene_, triangle), attributes, makeShadingPoint(scene_, hit, attributes, wo), wo};
    }

    void addEmission(const Hit& hit, const Surface& surface) {
        if (surface.isUnlit()) {
            return add(throughput_ * glm::vec3(baseColor(scene_, surface.material, surface.attributes)));
        }
        if (!surface.point.front && (surface.material.flags & kMaterialDoubleSided) == 0) return;
        const glm::vec3 le = emission(scene_, surface.material, surface.attributes);
        if (isBlack(le)) return;
        float w = 1;
        if (surface.triangle.light != kNone) {
            const LightRecord& light = scene_.lights[surface.triangle.light];
            w = powerHeuristic(pdfBsdf_, lights_.pdfTriangle(light, ray_.direction, hit.t));
        }
        add(throughput_ * le * w);
    }

    [[nodiscard]] Scattering prepare(const Surface& surface) const {
        const glm::vec3 base(baseColor(scene_, surface.material, surface.attributes));
        const glm::vec2 mr = metallicRoughness(scene_, surface.material, surface.attributes);
        const Frame<float> frame(surface.point.ns);
        const glm::vec3 wo = frame.toLocal(surface.wo);
        return {surface.point, frame, makeBsdf(base, mr.x, mr.y, std::abs(wo.z)), wo};
    }

    /// Next event estimation.
    void addLight(const Scattering& at) {
        if (!at.bsdf.hasDensity() || lights_.empty()) return;
        const auto light = lights_.sample(at.point.position, sample_.get1D(dimension(kDimLight)),
                                          sample_.get2D(dimension(kDimLightPoint)));
        if (!light || glm::dot(light->wi, at.point.ng) <= 0) return;
        const glm::vec3 wi = at.frame.toLocal(light->wi);
        const glm::vec3 f = evalBsdf(at.bsdf, at.wo, wi);
        const float w = light->punctual ? 1 : powerHeuristic(light->pdf, pdfBsdf(at.bsdf, at.wo, wi));
        const glm::vec3 contribution = throughput_ * f * std::abs(wi.z) * light->radiance / light->pdf * w;
        if (isBlack(contribution) || isOccluded(at.point.rayOrigin, *light)) return;
        add(contribution);
    }

    bool isOccluded(const glm::vec3& origin, const LightSample& light) {
        ++tally_.shadowRays;
        const std::uint32_t key = alphaKey(sample_.id, bounce_, kRayShadow);
        if (light.infinite) return anyHit(scene_, {origin, light.wi}, std::numeric_limits<float>::infinity(), key);
        return anyHit(scene_, {origin, light.end - origin}, 1, key);
    }

    /// Draws the next ray; false where the path ends.
    bool scatter(const Scattering& at) {
        const auto drawn =
            sampleBsdf(at.bsdf, at.wo, sample_.get1D(dimension(kDimLobe)), sample_.get2D(dimension(kDimBsdf)));
        const glm::vec3 wi = at.frame.toWorld(drawn.wi);
        if (isBlack(drawn.weight) || glm::dot(wi, at.point.ng) <= 0) return false;
        throughput_ *= drawn.weight;
        pdfBsdf_ = drawn.pdf;
        ray_ = {at.point.rayOrigin, wi};
        return !isBlack(throughput_);
    }

    /// Russian roulette.
    bool survives() {
        if (params_.rrMode == kRouletteOff || bounce_ + 1 < params_.rrDepth) return true;
        const float q = params_.rrMode == kRouletteFixed
                            ? params_.rrFixed
                            : std::min(1.0F, std::max({throughput_.x, throughput_.y, throughput_.z}));
        if (!(sample_.get1D(dimension(kDimRoulette)) < q)) return false;
        throughput_ /= q;
        return true;
    }

    const SceneArrays& scene_;
    const RenderParams& params_;
    const Lights& lights_;
    PathSample sample_;
    PathTally& tally_;
    Ray ray_;
    glm::vec3 throughput_{1};
    float pdfBsdf_ = std::numeric_limits<float>::infinity();
    std::uint32_t bounce_ = 0;
};

PathTracer::PathTracer(const SceneArrays& scene, const RenderOptions& options)
    : scene_(scene), params_(options.params), lights_(scene), bits_(samplerBits(options.sampler)) {}

void PathTracer::trace(std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally) const {
    Path(*this, x, y, index, tally).trace();
}

}  // namespace vkpt::reference
