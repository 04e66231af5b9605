// Metres from the camera: along its axis, of a panorama as the ray goes.
float cameraDepth(vec3 position) {
    vec3 way = position - render.eye;
    return kProjection == kProjectionPanorama ? length(way) : dot(way, render.forward);
}
