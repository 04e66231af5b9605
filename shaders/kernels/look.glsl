// Stage 3b of integrators that ask what a camera ray met, and no BSDF: ambient occlusion, and what layers hold.
// [estimator.md, Integrators]
#include "kernels/preamble.glsl"
#include "kernels/draw.glsl"
const uint kAppends = 1u;   // to the queue of shadow rays
#include "kernels/append.glsl"
#include "kernels/light_layers.glsl"
#include "kernels/camera_depth.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"
#include "bsdf/hemisphere.glsl"
#include "kernels/shadow_item.glsl"

vec3 lookAt(ShadingPoint p, vec2 b12) {
    if (kIntegrator == kIntegratorAlbedo) return surfaceBaseColor(p.material, p.uv, p.maps.baseColor).rgb;
    if (kIntegrator == kIntegratorNormal) return 0.5 * p.frame.n + 0.5;
    if (kIntegrator == kIntegratorUv) return vec3(p.uv.uv0 - floor(p.uv.uv0), 0.0);
    if (kIntegrator == kIntegratorDepth) return vec3(cameraDepth(p.position));
    if (kIntegrator == kIntegratorBarycentrics) return vec3(1.0 - b12.x - b12.y, b12);
    if (kIntegrator == kIntegratorCost) return vec3(1.0);   // the throughput holds it
    return vec3(0.0);                                       // ao adds what its shadow ray brings
}

// Integrator ao: a direction over the hemisphere, worth cosI / (pi pdf).
ShadowItem makeOcclusionItem(ShadingPoint p, SampleId id, vec3 throughput) {
    vec3 wi = sampleHemisphere(samplePath2D(id, bounceDimension(kDimBsdf))), direction = toWorld(p.frame, wi);
    float worth = kHemisphere == kHemisphereUniform ? 2.0 * wi.z : 1.0;
    bool outside = wi.z > 0.0 && dot(direction, p.ng) > 0.0;
    return ShadowItem(leaveSurface(p, wi), direction, outside ? throughput * worth : vec3(0.0), render.aoDistance, 0u);
}

void main() {
    uint i = gl_GlobalInvocationID.x, path = 0u;
    bool live = i < queueSize(batch.bounce, kQueueHit), lit = false;
    ShadowItem shadow;
    if (live) {
        path = counters[queueArray(batch.bounce, kQueueHit) + i];
        vec3 direction = loadStateFloat(kStateDirection, path).xyz, throughput = loadStateFloat(kStateThroughput, path).xyz;
        uvec4 hit = loadState(kStateHit, path);
        uint instance = loadState(kStateDirection, path).w;
        ShadingPoint p = makeShadingPoint(hit.y, instance, uintBitsToFloat(hit.zw), -direction);
        contribute(path, throughput * lookAt(p, uintBitsToFloat(hit.zw)), true, kMetSurface, 0u, 0u);
        if (kIntegrator == kIntegratorAo) {
            shadow = makeOcclusionItem(p, sampleIdOf(path), throughput);
            lit = maxMagnitude(shadow.radiance) > 0.0;
        }
    }
    if (kIntegrator != kIntegratorAo) return;
    uint slots[kAppends] = appendSlots(uint[](queueCounter(batch.bounce, kQueueShadow)), bool[](lit));
    if (lit) storeShadowItem(slots[0], path, shadow);
}
