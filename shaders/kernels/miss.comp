#version 460
// Stage 3a: paths that left the scene meet the environment, or the background if they are camera rays.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/contribution.glsl"
#include "lights/environment.glsl"
#include "math/mis.glsl"

// What a camera ray sees behind everything.
vec3 backgroundSeen(vec3 environment) {
    if (render.backgroundMode == kBackgroundColor) return render.background;
    return render.backgroundMode == kBackgroundTransparent ? vec3(0.0) : environment;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queueSize(batch.bounce, kQueueMiss)) return;
    uint path = counters[queueArray(batch.bounce, kQueueMiss) + i];
    vec3 direction = loadStateFloat(kStateDirection, path).xyz;
    vec4 environment = vec4(0.0);
    float pmf = 0.0;
    if (kHasEnvironment != 0u) {
        environment = environmentLookup(direction);
        if (scene.envLight != kNone) pmf = sceneWordFloat(scene.lights + scene.envLight * 4u + 1u).w;
    }
    if (batch.bounce == 0u) {
        uint met = render.backgroundMode == kBackgroundTransparent ? kMetNothing : kMetBackground;
        addContribution(path, backgroundSeen(environment.rgb), true, met);
        return;
    }
    float pdfBsdf = loadStateFloat(kStateOrigin, path).w;
    float weight = pdfBsdf < 0.0 ? 1.0 : powerHeuristic(pdfBsdf, pmf * environment.w);
    vec3 throughput = loadStateFloat(kStateThroughput, path).xyz;
    addContribution(path, throughput * environment.rgb * weight, false, kMetNothing);
}
