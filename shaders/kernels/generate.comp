#version 460
// Stage 1: a camera ray for every path of the batch. Its sums begin at the first stage that adds to them.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/draw.glsl"

struct CameraRay {
    vec3 origin, direction;
};

// Where on the film, in pixels, and in z the filter's weight.
vec3 filmPosition(SampleId id, vec2 u) {
    vec2 pixel = vec2(id.pixel & 0xffffu, id.pixel >> 16u);
    if (kHasFilter == 0u) return vec3(pixel + u, 1.0);
    vec2 t = float(kFilterSteps) * u, cell = floor(t), into = t - cell;
    FilterCell x = loadFilterCell(uint(cell.x)), y = loadFilterCell(uint(cell.y));
    return vec3(pixel + 0.5 + vec2(mix(x.begin, x.end, into.x), mix(y.begin, y.end, into.y)), x.weight * y.weight);
}

// Through a pinhole; (s, t) runs over [-1,1]^2 of the window, or of the whole sphere. [estimator.md, Frame and camera]
CameraRay pinholeRay(vec2 film) {
    float s = 2.0 * film.x / float(render.width) - 1.0, t = 1.0 - 2.0 * film.y / float(render.height);
    if (kProjection == kProjectionPanorama) {
        vec2 phi = cosSinTurns(0.5 * s), theta = cosSinTurns(0.25 - 0.25 * t);
        return CameraRay(render.eye, theta.y * (phi.x * render.forward + phi.y * render.right) + theta.x * render.up);
    }
    vec3 onWindow = s * render.right + t * render.up;
    if (kProjection == kProjectionOrthographic) return CameraRay(render.eye + onWindow, render.forward);
    return CameraRay(render.eye, normalize(render.forward + onWindow));
}

// Through a point of the lens, so that what lies at focusDistance stays where it is.
CameraRay lensRay(CameraRay pinhole, vec2 u) {
    vec3 focus = pinhole.origin + pinhole.direction * (render.focusDistance / dot(pinhole.direction, render.forward));
    vec2 onLens = render.lensRadius * squareToDisk(u);
    vec3 origin = pinhole.origin + onLens.x * normalize(render.right) + onLens.y * normalize(render.up);
    return CameraRay(origin, normalize(focus - origin));
}

void main() {
    uint path = gl_GlobalInvocationID.x;
    if (path >= batch.pathCount) return;
    SampleId id = sampleIdOf(path);
    uvec2 numbers[2] = uvec2[2](uvec2(0u), uvec2(0u));   // of kDimFilter and kDimLens; in a loop as in shade.glsl
    for (uint i = 0u; i < (kHasLens != 0u ? 2u : 1u); ++i) numbers[i] = samplerPair(id, (kDimFilter >> 1u) + i);
    vec3 film = filmPosition(id, toUnit(numbers[0]));
    CameraRay ray = pinholeRay(film.xy);
    if (kHasLens != 0u) ray = lensRay(ray, toUnit(numbers[1]));
    storeStateFloat(kStateOrigin, path, vec4(ray.origin, -1.0));
    storeStateFloat(kStateDirection, path, vec4(ray.direction, 0.0));
    storeStateFloat(kStateThroughput, path, vec4(vec3(film.z), 0.0));
    counters[queueArray(0u, kQueueRay) + path] = path;
}
