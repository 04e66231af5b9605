#include "reference/looks.h"

#include "dimensions.h"
#include "reference/hemisphere.h"

namespace vkpt::reference {

namespace {

std::optional<DirectLight> lookOut(const Transport& transport, const PathState& camera, const ShadingPoint& point) {
    const RenderParams& params = transport.params;
    const Frame<float> frame(point.ns);
    const glm::vec3 wi = sampleHemisphere(params.hemisphere, camera.sample.get2D(transport.dimension(0, kDimBsdf)));
    const glm::vec3 direction = frame.toWorld(wi);
    if (!(wi.z > 0) || !(glm::dot(direction, point.ng) > 0)) return std::nullopt;
    const float worth = wi.z / (kPiOf<float> * hemispherePdf(params.hemisphere, wi));
    return DirectLight{{point.rayOrigin, direction}, params.aoDistance, camera.throughput * worth};
}

/// That light sampling, not the BSDF, drew the direction.
float lightProbability(const Surface& surface) {
    if (surface.isUnlit()) return 0;
    const auto path = surface.findLight();
    if (!path) return 0;
    return path->light.punctual ? 1 : path->light.pdf / (path->light.pdf + path->pdfBsdf);
}

glm::vec3 valueOf(const Transport& transport, const Surface& surface, const Hit& hit) {
    const glm::vec2& uv = surface.attributes().coords.uv0;
    switch (static_cast<IntegratorId>(transport.params.integrator)) {
        case IntegratorId::Albedo:
            return baseColor(transport.scene, surface.material(), surface.attributes());
        case IntegratorId::Normal:
            return (surface.point().ns + 1.0F) / 2.0F;
        case IntegratorId::Uv:
            return {uv - glm::floor(uv), 0};
        case IntegratorId::Depth:
            return glm::vec3(depthOf(transport.params, surface.point().position));
        case IntegratorId::Barycentrics:
            return hit.barycentrics;
        case IntegratorId::LightProbability:
            return glm::vec3(lightProbability(surface));
        default:
            return glm::vec3(0);
    }
}

}  // namespace

float depthOf(const RenderParams& params, const glm::vec3& position) {
    const glm::vec3 way = position - params.eye;
    return params.projection == kProjectionPanorama ? glm::length(way) : glm::dot(way, params.forward);
}

PathVertex look(const Transport& transport, const PathState& camera, const Hit& hit) {
    const Surface surface(transport, camera, hit);
    PathVertex vertex;
    vertex.point = surface.point();
    vertex.material = surface.materialIndex();
    if (transport.params.integrator == static_cast<std::uint32_t>(IntegratorId::Ao))
        vertex.direct = lookOut(transport, camera, surface.point());
    else
        vertex.emitted = camera.throughput * valueOf(transport, surface, hit);
    return vertex;
}

}  // namespace vkpt::reference
