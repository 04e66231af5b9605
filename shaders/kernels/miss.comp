#version 460
// Stage 3a: paths that left the scene meet the environment, or the background if they are camera rays.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/light_layers.glsl"
#include "lights/environment.glsl"
#include "kernels/clamp.glsl"
#include "kernels/weights.glsl"
#include "kernels/media.glsl"

// Looks see nothing behind surfaces.
bool seesBackground() { return kIntegrator == kIntegratorPath || kIntegrator == kIntegratorDirect; }

// What a camera ray sees behind everything.
vec3 backgroundSeen(vec3 environment) {
    if (render.backgroundMode == kBackgroundColor) return render.background;
    return render.backgroundMode == kBackgroundTransparent ? vec3(0.0) : environment;
}

// Its environment with the weight of BSDF samples.
vec3 environmentMet(uint path, vec4 environment) {
    vec4 throughput = loadStateFloat(kStateThroughput, path);
    vec3 radiance = throughput.xyz * environment.rgb;
    radiance *= transmittance(floatBitsToUint(throughput.w), uintBitsToFloat(0x7f800000u));
    if (scene.envLight == kNone) return radiance;
    float pmf = sceneWordFloat(scene.lights + scene.envLight * 4u + 1u).w;
    return radiance * weightOfBsdfSample(loadStateFloat(kStateOrigin, path).w, pmf * environment.w);
}

// What a path adds that met nothing. `first`: of a camera ray.
vec3 seenBeyond(uint path, bool first) {
    vec3 throughput = loadStateFloat(kStateThroughput, path).xyz;
    if (kIntegrator == kIntegratorCost) return throughput;
    if (!seesBackground()) return vec3(0.0);
    vec4 environment = vec4(0.0);
    if (kHasEnvironment != 0u) environment = environmentLookup(loadStateFloat(kStateDirection, path).xyz);
    if (first) return throughput * backgroundSeen(environment.rgb);
    return clampIndirect(environmentMet(path, environment), batch.bounce);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queueSize(batch.bounce, kQueueMiss)) return;
    uint path = counters[queueArray(batch.bounce, kQueueMiss) + i];
    bool first = batch.bounce == 0u;
    if (first && batch.round != 0u) return;   // of integrator direct: it has seen it in the first
    bool met = first && seesBackground() && render.backgroundMode != kBackgroundTransparent;
    contribute(path, seenBeyond(path, first), first, met ? kMetBackground : kMetNothing, batch.bounce, scene.groupBehind);
}
