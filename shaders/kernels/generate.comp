#version 460
// Stage 1: a camera ray for every path of the batch. Its sums begin at the first stage that adds to them.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/draw.glsl"

struct CameraRay {
    vec3 origin, direction;
};

// Box filter of one pixel; (s, t) runs over [-1,1]^2 of the window. [estimator.md, Frame and camera]
CameraRay generateCameraRay(SampleId id) {
    vec2 film = vec2(id.pixel & 0xffffu, id.pixel >> 16u) + samplePath2D(id, kDimFilter);
    float s = 2.0 * film.x / float(render.width) - 1.0, t = 1.0 - 2.0 * film.y / float(render.height);
    vec3 onWindow = s * render.right + t * render.up;
    if (render.projection == kProjectionOrthographic) return CameraRay(render.eye + onWindow, render.forward);
    return CameraRay(render.eye, normalize(render.forward + onWindow));
}

void main() {
    uint path = gl_GlobalInvocationID.x;
    if (path >= batch.pathCount) return;
    CameraRay ray = generateCameraRay(sampleIdOf(path));
    storeStateFloat(kStateOrigin, path, vec4(ray.origin, -1.0));
    storeStateFloat(kStateDirection, path, vec4(ray.direction, 0.0));
    storeStateFloat(kStateThroughput, path, vec4(1.0));
    counters[queueArray(0u, kQueueRay) + path] = path;
}
