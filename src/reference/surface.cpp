#include "reference/surface.h"

#include <algorithm>

#include "dimensions.h"
#include "reference/hemisphere.h"
#include "reference/medium.h"
#include "scene/render_options.h"

namespace vkpt::reference {

namespace {

float largestMagnitude(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Frame<float> frameOf(const MaterialRecord& material, const ShadingPoint& point) {
    return modelOf(material) == BsdfId::Gltf ? Frame<float>(point.ns) : Frame<float>(point.ns, point.tangent);
}

}  // namespace

glm::vec3 Transport::clamped(const glm::vec3& contribution, std::uint32_t scatterings) const {
    const float most = params.clampIndirect, size = largestMagnitude(contribution);
    return most > 0 && scatterings >= 2 && size > most ? contribution * (most / size) : contribution;
}

std::uint32_t Transport::dimension(std::uint32_t bounce, std::uint32_t use) const {
    return (hasLens() ? kDimBounceBehindLens : kDimBounce) + bounce * kDimBounceStride + use;
}

Surface::Surface(const Transport& transport, const PathState& state, const Hit& hit)
    : transport_(transport),
      scene_(transport.scene),
      params_(transport.params),
      state_(state),
      hit_(hit),
      triangle_(scene_.triangles[hit.triangle]),
      material_(materialOf(scene_, triangle_)),
      throughput_(state.throughput * transmittance(scene_, state.medium, hit.t)),
      attributes_(interpolateAttributes(scene_, triangle_, hit.barycentrics)),
      woWorld_(-state.ray.direction),
      point_(makeShadingPoint(scene_, hit, attributes_, woWorld_)),
      frame_(frameOf(material_, point_)),
      wo_(frame_.toLocal(woWorld_)),
      bsdf_(bsdfOf(scene_, triangle_, attributes_, point_.front)) {}

PathVertex Surface::shade() const {
    PathVertex vertex;
    vertex.point = point_;
    vertex.material = materialIndex();
    if (state_.bounce > 0 || state_.round == 0) vertex.emitted = emitted();                 // 3
    if (isUnlit() || state_.bounce == pathDepth(params_)) return vertex;                    // 4
    if (state_.round < transport_.heuristic.lightSamples()) vertex.direct = sampleLight();  // 5
    if (state_.round >= transport_.heuristic.bsdfSamples()) return vertex;
    vertex.next = scatter();                                       // 6
    if (vertex.next && !survives(*vertex.next)) vertex.next = {};  // 7
    return vertex;
}

std::uint32_t Surface::dimension(std::uint32_t use) const {
    return transport_.dimension(state_.numbersOfSurface(), use);
}

/// Whether --hemisphere, not the BSDF, decides on directions.
bool Surface::drawsHemisphere() const { return params_.hemisphere != kHemisphereBsdf && !needsItsOwnDraws(bsdf_); }

float Surface::pdf(const glm::vec3& wi) const {
    return drawsHemisphere() ? hemispherePdf(params_.hemisphere, wi) : pdfBsdf(bsdf_, wo_, wi);
}

/// Whether the surface itself lets light pass from wo to wi: both normals agree on the side of wi.
bool Surface::isConsistent(const glm::vec3& wiLocal, const glm::vec3& wiWorld) const {
    const float side = glm::dot(wiWorld, point_.ng);
    return wiLocal.z > 0 ? side > 0 : side < 0;
}

const glm::vec3& Surface::originTowards(const glm::vec3& wiLocal) const {
    return wiLocal.z > 0 ? point_.rayOrigin : point_.farOrigin;
}

std::uint32_t Surface::mediumTowards(const glm::vec3& wiLocal) const {
    if (wiLocal.z > 0 || modelOf(material_) != BsdfId::Dielectric) return state_.medium;
    return point_.front ? materialIndex() : kNone;
}

glm::vec3 Surface::emitted() const {
    glm::vec3 le(0);
    float w = 1;
    if (isUnlit()) {
        le = glm::vec3(baseColor(scene_, material_, attributes_));
    } else if (point_.front || (material_.flags & kMaterialDoubleSided) != 0) {
        le = emission(scene_, material_, attributes_);
        if (isBlack(le)) return le;
        const bool isLight = triangle_.light != kNone;
        const float pdfLight =
            isLight ? transport_.lights.pdfTriangle(scene_.lights[triangle_.light], state_.ray.origin) : 0;
        w = transport_.heuristic.ofEmission(state_.pdfBsdf, isLight, pdfLight);
    }
    return transport_.clamped(throughput_ * le * w, state_.bounce);
}

std::optional<Surface::LightPath> Surface::findLight() const {
    if (transport_.lights.empty() || !hasDensity(bsdf_, wo_)) return std::nullopt;
    const auto light = transport_.lights.sample(point_.position, state_.sample.bits2D(dimension(kDimLight)));
    if (!light) return std::nullopt;
    const glm::vec3 wi = frame_.toLocal(light->wi);
    if (!isConsistent(wi, light->wi)) return std::nullopt;
    const LightPath path{*light, wi, evalBsdf(bsdf_, wo_, wi), pdf(wi)};
    if (isBlack(path.f) || isBlack(light->radiance)) return std::nullopt;
    return path;
}

/// Next event estimation.
std::optional<DirectLight> Surface::sampleLight() const {
    const auto path = findLight();
    if (!path) return std::nullopt;
    const LightSample& light = path->light;
    const float w = light.punctual ? 1 : transport_.heuristic.ofLight(light.pdf, path->pdfBsdf);
    DirectLight direct;
    direct.contribution = throughput_ * path->f * std::abs(path->wi.z) * light.radiance / light.pdf * w;
    direct.contribution *= transmittance(scene_, mediumTowards(path->wi), light.distance);
    direct.contribution /= static_cast<float>(transport_.heuristic.lightSamples());
    direct.contribution = transport_.clamped(direct.contribution, state_.bounce + 1);
    if (isBlack(direct.contribution)) return std::nullopt;
    if (!scene_.lightGroups.empty()) direct.group = scene_.lightGroups.ofLight[light.light];
    const glm::vec3& origin = originTowards(path->wi);
    direct.shadowRay = {origin, light.infinite ? light.wi : light.end - origin};
    if (light.infinite) direct.tMax = std::numeric_limits<float>::infinity();
    return direct;
}

BsdfSample<float> Surface::draw() const {
    const PathSample& sample = state_.sample;
    const Vec2<float> u = sample.get2D(dimension(kDimBsdf));
    if (drawsHemisphere()) {
        BsdfSample<float> drawn = towards(sampleHemisphere(params_.hemisphere, u));
        drawn.pdf = hemispherePdf(params_.hemisphere, drawn.wi);
        if (drawn.pdf > 0) drawn.weight = evalBsdf(bsdf_, wo_, drawn.wi) * (drawn.wi.z / drawn.pdf);
        return drawn;
    }
    if (modelOf(material_) != BsdfId::Gltf) return sampleBsdf(bsdf_, wo_, sample.get1D(dimension(kDimLobe)), u);
    return sampleBsdf(bsdf_, wo_, u.x, {gltfAfterChoices(bsdf_, wo_, u.x), u.y});
}

/// Draws the next ray; nothing where the path ends.
std::optional<PathState> Surface::scatter() const {
    const auto drawn = draw();
    const glm::vec3 wi = frame_.toWorld(drawn.wi);
    if (isBlack(drawn.weight) || !isConsistent(drawn.wi, wi)) return std::nullopt;
    PathState next = state_;
    ++next.bounce;
    next.ray = {originTowards(drawn.wi), wi};
    next.throughput = throughput_ * drawn.weight;
    next.throughput /= static_cast<float>(transport_.heuristic.bsdfSamples());
    next.pdfBsdf = drawn.pdf;
    next.medium = mediumTowards(drawn.wi);
    if (isBlack(next.throughput)) return std::nullopt;
    return next;
}

/// Russian roulette.
bool Surface::survives(PathState& next) const {
    const bool direct = params_.integrator == static_cast<std::uint32_t>(IntegratorId::Direct);
    if (direct || params_.rrMode == kRouletteOff || state_.bounce + 1 < params_.rrDepth) return true;
    const float q =
        params_.rrMode == kRouletteFixed ? params_.rrFixed : std::min(1.0F, largestMagnitude(next.throughput));
    if (!(state_.sample.get1D(dimension(kDimRoulette)) < q)) return false;
    next.throughput /= q;
    return true;
}

}  // namespace vkpt::reference
