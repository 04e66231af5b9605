// Stage 3b: paths that met a surface: its emission, one light sample, one BSDF sample, Russian roulette.
// The steps are those of estimator.md. Compiled for each shade group, whose file has defined VertexBsdf, kShadeQueue,
// makeVertexFrame, makeVertexBsdf, evaluateBsdf and sampleBsdf.
#include "lights/environment.glsl"
#include "lights/punctual.glsl"
#include "lights/sample.glsl"
#include "math/mis.glsl"

struct PathVertex {
    uint path;
    SampleId id;
    vec3 direction, wo, throughput;   // direction: wo in world space
    float pdfBsdf, t;
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
    vec4 direction = loadStateFloat(kStateDirection, path);
    uvec4 hit = loadState(kStateHit, path);
    v.direction = -direction.xyz;
    v.throughput = loadStateFloat(kStateThroughput, path).xyz;
    v.pdfBsdf = loadStateFloat(kStateOrigin, path).w;
    v.t = uintBitsToFloat(hit.x);
    v.point = makeShadingPoint(hit.y, floatBitsToUint(direction.w), uintBitsToFloat(hit.zw), v.direction);
    v.frame = makeVertexFrame(v.point);
    v.wo = toLocal(v.frame, v.direction);
    v.bsdf = makeVertexBsdf(v.point, v.wo);
    return v;
}

bool isUnlit(PathVertex v) { return kHasUnlit != 0u && (v.point.material.flags & kMaterialUnlit) != 0u; }

// Step 3: radiance emitted towards the path, with its MIS weight.
vec3 emittedRadiance(PathVertex v) {
    MaterialRecord m = v.point.material;
    if (isUnlit(v)) return surfaceBaseColor(m, v.point.uv, v.point.maps.baseColor).rgb;
    if (maxComponent(m.emissive) <= 0.0) return vec3(0.0);
    if (!v.point.front && (m.flags & kMaterialDoubleSided) == 0u) return vec3(0.0);
    vec3 emission = m.emissive * v.point.maps.emissive.rgb;
    if (kHasTriangleLights == 0u || v.point.light == kNone || v.pdfBsdf < 0.0) return emission;
    uint light = scene.lights + v.point.light * 4u;
    float pmf = sceneWordFloat(light + 1u).w, area = sceneWordFloat(light + 2u).w;
    float pdfLight = pmf * v.t * v.t / (area * abs(dot(v.direction, v.point.nGeometric)));
    return emission * powerHeuristic(v.pdfBsdf, pdfLight);
}

struct ShadowItem {
    vec3 origin, target, radiance;
    float tMax;
};

// Origin of a ray to local direction wi.
vec3 leaveSurface(ShadingPoint p, vec3 wi) { return p.position + p.ng * (wi.z < 0.0 ? -p.offset : p.offset); }

// Whether both normals see wi on the same side.
bool isOnOneSide(ShadingPoint p, vec3 wi, vec3 direction) { return wi.z * dot(direction, p.ng) > 0.0; }

// Step 5: next event estimation. radiance 0: no shadow ray.
ShadowItem sampleDirect(PathVertex v) {
    ShadowItem item = ShadowItem(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    if (scene.lightCount == 0u) return item;
    LightSample light = sampleLight(v.point.position, v.numbers[kDimLight / 2u]);
    vec3 wi = toLocal(v.frame, light.wi), f;
    float pdf;
    evaluateBsdf(v.bsdf, v.wo, wi, f, pdf);
    if (!isOnOneSide(v.point, wi, light.wi) || maxComponent(light.radiance) <= 0.0 || light.pdf <= 0.0) return item;
    float weight = light.delta ? 1.0 : powerHeuristic(light.pdf, pdf);
    item.radiance = v.throughput * f * light.radiance * (abs(wi.z) * weight / light.pdf);
    item.origin = leaveSurface(v.point, wi);
    item.target = light.infinite ? light.target : light.target - item.origin;
    item.tMax = light.infinite ? uintBitsToFloat(0x7f800000u) : 1.0;
    return item;
}

// Steps 6 and 7: the next segment; false where the path ends.
bool samplePathDirection(PathVertex v, out vec3 origin, out vec3 direction, out vec3 throughput, out float pdf) {
    vec2 choices = toUnit(v.numbers[kDimLobe / 2u]);  // of a lobe; kDimRoulette: to survive
    BsdfSample s = sampleBsdf(v.bsdf, v.wo, choices.x, toUnit(v.numbers[kDimBsdf / 2u]));
    direction = toWorld(v.frame, s.wi);
    origin = leaveSurface(v.point, s.wi);
    throughput = v.throughput * s.weight;
    pdf = s.pdf;
    float brightest = maxComponent(throughput);
    if (brightest <= 0.0 || !isOnOneSide(v.point, s.wi, direction)) return false;
    if (render.rrMode != kRouletteOff && batch.bounce + 1u >= render.rrDepth) {
        float q = render.rrMode == kRouletteFixed ? render.rrFixed : min(1.0, brightest);
        if (choices.y >= q) return false;
        throughput /= q;
    }
    return true;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool live = i < queueSize(batch.bounce, kShadeQueue), lit = false, scattered = false;
    PathVertex v;
    ShadowItem shadow;
    vec3 origin, direction, throughput;
    float pdf;
    if (live) {
        v = loadPathVertex(counters[queueArray(batch.bounce, kShadeQueue) + i]);
        vec3 emission = v.throughput * emittedRadiance(v);
        bool first = batch.bounce == 0u;
        if (first || maxComponent(emission) > 0.0) addContribution(v.path, emission, first, first ? kMetSurface : kMetNothing);
        if (batch.bounce < render.maxDepth && !isUnlit(v)) {
            shadow = sampleDirect(v);
            lit = maxComponent(shadow.radiance) > 0.0;
            scattered = samplePathDirection(v, origin, direction, throughput, pdf);
        }
    }
    uint shadowSlot = appendSlot(batch.bounce, kQueueShadow, lit);
    uint raySlot = appendSlot(batch.bounce + 1u, kQueueRay, scattered);
    if (lit) {
        storeStateFloat(kShadowOrigin, shadowSlot, vec4(shadow.origin, uintBitsToFloat(v.path)));
        storeStateFloat(kShadowTarget, shadowSlot, vec4(shadow.target, shadow.tMax));
        storeStateFloat(kShadowRadiance, shadowSlot, vec4(shadow.radiance, 0.0));
    }
    if (scattered) {
        storeStateFloat(kStateOrigin, v.path, vec4(origin, pdf));
        storeStateFloat(kStateDirection, v.path, vec4(direction, 0.0));
        storeStateFloat(kStateThroughput, v.path, vec4(throughput, 0.0));
        counters[queueArray(batch.bounce + 1u, kQueueRay) + raySlot] = v.path;
    }
}
