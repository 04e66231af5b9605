// A contribution of light that has scattered so often: at most clampIndirect, where that is asked for.
vec3 clampIndirect(vec3 c, uint scatterings) {
    float largest = maxMagnitude(c);
    bool clamps = render.clampIndirect > 0.0 && scatterings >= 2u && largest > render.clampIndirect;
    return clamps ? c * (render.clampIndirect / largest) : c;
}
