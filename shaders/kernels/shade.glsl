// Stage 3b: paths that met a surface: its emission, one light sample, one BSDF sample, Russian roulette.
// The steps are those of estimator.md. Compiled for each shade group, whose file has defined VertexBsdf, kShadeQueue,
// makeVertexFrame, makeVertexBsdf, evaluateBsdf and sampleBsdf.
#include "lights/environment.glsl"
#include "lights/punctual.glsl"
#include "lights/sample.glsl"
#include "kernels/clamp.glsl"
#include "kernels/weights.glsl"
#include "kernels/media.glsl"
#include "kernels/shadow_item.glsl"
#include "geometry/triangle.glsl"
#include "geometry/search_list.glsl"
#include "material/alpha.glsl"

struct PathVertex {
    uint path;
    SampleId id;
    vec3 origin, direction, wo, throughput;  // origin: of the segment that met it; direction: wo in world space
    float pdfBsdf;
    uint medium;                      // that the path came through
    uint group;                       // of the surface's own light
    ShadingPoint point;
    ShadingFrame frame;
    VertexBsdf bsdf;
    uvec2 numbers[3];  // the bounce's random bits of dimensions 2 i and 2 i + 1
};

PathVertex loadPathVertex(uint path) {
    PathVertex v;
    v.path = path;
    v.id = sampleIdOf(path);
    // In a loop, since drivers inline every call with all samplers before they strip those that
    // are not in use; and first, since loops of samplers save and load all that is live.
    [[unroll]] for (uint i = 0u; i < 3u; ++i) v.numbers[i] = samplerPair(v.id, (bounceDimension(0u) >> 1u) + i);
    vec4 direction = loadStateFloat(kStateDirection, path), throughput = loadStateFloat(kStateThroughput, path);
    uvec4 hit = loadState(kStateHit, path);
    v.direction = -direction.xyz;
    v.medium = floatBitsToUint(throughput.w);
    vec4 origin = loadStateFloat(kStateOrigin, path);
    v.origin = origin.xyz;
    v.pdfBsdf = origin.w;
    v.throughput = throughput.xyz * transmittance(v.medium, uintBitsToFloat(hit.x));
    v.point = makeShadingPoint(hit.y, floatBitsToUint(direction.w), uintBitsToFloat(hit.zw), v.direction);
    v.frame = makeVertexFrame(v.point);
    v.wo = toLocal(v.frame, v.direction);
    v.group = emitterGroup(hit.y, floatBitsToUint(direction.w));
    v.bsdf = makeVertexBsdf(v.point, v.wo);
    return v;
}

bool isUnlit(PathVertex v) { return kHasUnlit != 0u && (v.point.material.flags & kMaterialUnlit) != 0u; }

// The medium into which wi goes.
uint mediumOf(PathVertex v, vec3 wi) {
    if (kHasMedia == 0u || wi.z >= 0.0) return v.medium;
    return v.point.front ? v.point.materialIndex + 1u : 0u;
}

// Step 3: radiance emitted towards the path, with its MIS weight.
vec3 emittedRadiance(PathVertex v) {
    MaterialRecord m = v.point.material;
    if (isUnlit(v)) return surfaceBaseColor(m, v.point.uv, v.point.maps.baseColor).rgb;
    if (maxComponent(m.emissive) <= 0.0) return vec3(0.0);
    if (!v.point.front && (m.flags & kMaterialDoubleSided) == 0u) return vec3(0.0);
    vec3 emission = m.emissive * v.point.maps.emissive.rgb;
    if (kHasTriangleLights == 0u || v.point.light == kNone) return emission;
    LightRecord light = loadLight(v.point.light);
    return emission * weightOfBsdfSample(v.pdfBsdf, triangleLightPdf(light, seenFrom(light, v.origin)));
}

// Whether both normals see wi on the same side.
bool isOnOneSide(ShadingPoint p, vec3 wi, vec3 direction) { return wi.z * dot(direction, p.ng) > 0.0; }

// A light sample, and what the BSDF makes of it.
struct DirectSample {
    LightSample light;
    vec3 wi, f;   // f 0: nothing arrives
    float pdf;
};

DirectSample sampleDirect(PathVertex v) {
    DirectSample s;
    s.light = sampleLight(v.point.position, v.numbers[kDimLight / 2u]);
    s.wi = toLocal(v.frame, s.light.wi);
    evaluateBsdf(v.bsdf, v.wo, s.wi, s.f, s.pdf);
    bool arrives = isOnOneSide(v.point, s.wi, s.light.wi) && maxComponent(s.light.radiance) > 0.0 && s.light.pdf > 0.0;
    if (!arrives) s.f = vec3(0.0);
    return s;
}

// Step 5: next event estimation.
ShadowItem makeShadowItem(PathVertex v, DirectSample s) {
    ShadowItem item;
    float weight = s.light.delta ? 1.0 : weightOfLightSample(s.light.pdf, s.pdf);
    vec3 radiance = v.throughput * s.f * s.light.radiance * (abs(s.wi.z) * weight / (s.light.pdf * lightSamples()));
    radiance *= transmittance(mediumOf(v, s.wi), s.light.distance);
    item.radiance = maxComponent(s.f) > 0.0 ? clampIndirect(radiance, batch.bounce + 1u) : vec3(0.0);
    item.origin = leaveSurface(v.point, s.wi);
    item.target = s.light.infinite ? s.light.target : s.light.target - item.origin;
    item.tMax = s.light.infinite ? uintBitsToFloat(0x7f800000u) : 1.0;
    item.group = s.light.group;
    return item;
}

// What integrator light-probability shows.
float lightProbability(PathVertex v, DirectSample s) {
    if (maxComponent(s.f) <= 0.0 || isUnlit(v)) return 0.0;
    return s.light.delta ? 1.0 : s.light.pdf / (s.light.pdf + s.pdf);
}

// Steps 6 and 7: the next segment; false where the path ends.
bool samplePathDirection(PathVertex v, out vec3 origin, out vec3 direction, out vec4 throughput, out float pdf) {
    vec2 choices = toUnit(v.numbers[kDimLobe / 2u]);  // of a lobe; kDimRoulette: to survive
    BsdfSample s = sampleBsdf(v.bsdf, v.wo, choices.x, toUnit(v.numbers[kDimBsdf / 2u]));
    direction = toWorld(v.frame, s.wi);
    origin = leaveSurface(v.point, s.wi);
    throughput = vec4(v.throughput * s.weight / bsdfSamples(), uintBitsToFloat(mediumOf(v, s.wi)));
    pdf = s.pdf;
    float brightest = maxMagnitude(throughput.xyz);
    if (brightest <= 0.0 || !isOnOneSide(v.point, s.wi, direction)) return false;
    if (kIntegrator != kIntegratorPath) return true;
    if (render.rrMode != kRouletteOff && batch.bounce + 1u >= render.rrDepth) {
        float q = render.rrMode == kRouletteFixed ? render.rrFixed : min(1.0, brightest);
        if (choices.y >= q) return false;
        throughput.xyz /= q;
    }
    return true;
}

// Rounds of integrator direct take no more samples of a kind than are asked for.
bool takesLightSample() {
    if (kStrategy == kStrategyBsdf) return false;
    return kIntegrator != kIntegratorDirect || batch.round < render.lightSamples;
}
bool takesBsdfSample() { return kIntegrator != kIntegratorDirect || batch.round < render.bsdfSamples; }

// Whether a light sample arrives, where it is traced here: among few triangles, none of alpha. All invocations search
// the list together; those without a sample meet nothing.
bool arrives(bool lit, ShadowItem s) {
    vec4 target = lit ? vec4(s.target, s.tMax) : vec4(1.0, 1.0, 1.0, -1.0);
    return searchList(lit ? s.origin : vec3(0.0), target.xyz, target.w, AlphaKey(0u)).slot == kNone && lit;
}

// What the vertex itself adds to the film, and its light sample where that was traced here and `lit`; later rounds of
// integrator direct add no emission at the first.
void addLight(PathVertex v, vec3 radiance, bool lit, ShadowItem shadow) {
    bool camera = batch.bounce == 0u, first = camera && (kIntegrator != kIntegratorDirect || batch.round == 0u);
    vec3 emission = clampIndirect(v.throughput * radiance, batch.bounce), direct = lit ? shadow.radiance : vec3(0.0);
    bool emits = first || (!camera && maxMagnitude(emission) > 0.0);
    if (!emits) emission = vec3(0.0);
    if (!emits && !lit) return;
    addContributions(v.path, emission, direct, first, first ? kMetSurface : kMetNothing);
    addToLayers(v.path, emission, batch.bounce, v.group);
    if (kInlineShadows != 0u) addToLayers(v.path, direct, batch.bounce + 1u, shadow.group);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool live = i < queueSize(batch.bounce, kShadeQueue), lit = false, scattered = false;
    PathVertex v;
    ShadowItem shadow;
    vec3 emitted, origin, direction;
    vec4 throughput;
    float pdf;
    if (live) {
        v = loadPathVertex(counters[queueArray(batch.bounce, kShadeQueue) + i]);
        // Each of these functions is called once: drivers inline every call before they strip what constants exclude.
        DirectSample direct = sampleDirect(v);
        bool looks = kIntegrator == kIntegratorLightProbability;
        emitted = looks ? vec3(lightProbability(v, direct)) : emittedRadiance(v);
        if (!looks && batch.bounce < render.maxDepth && !isUnlit(v)) {
            shadow = makeShadowItem(v, direct);
            lit = takesLightSample() && maxMagnitude(shadow.radiance) > 0.0;
            scattered = samplePathDirection(v, origin, direction, throughput, pdf) && takesBsdfSample();
        }
    }
    uint counterOf[kAppends] =
        uint[](queueCounter(batch.bounce, kQueueShadow), queueCounter(batch.bounce + 1u, kQueueRay));
    uint slots[kAppends] = appendSlots(counterOf, bool[](lit, scattered));
    if (scattered) {
        storeStateFloat(kStateOrigin, v.path, vec4(origin, pdf));
        storeStateFloat(kStateDirection, v.path, vec4(direction, 0.0));
        storeStateFloat(kStateThroughput, v.path, throughput);
        counters[queueArray(batch.bounce + 1u, kQueueRay) + slots[1]] = v.path;
    }
    if (kInlineShadows != 0u)
        lit = arrives(lit, shadow);
    else if (lit)
        storeShadowItem(slots[0], v.path, shadow);
    if (live) addLight(v, emitted, lit && kInlineShadows != 0u, shadow);
}
