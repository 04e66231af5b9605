// Rays to lights, which kernel shadow traces, or shade itself (kInlineShadows).
struct ShadowItem {
    vec3 origin, target, radiance;   // target: from the origin to the light, or a direction; radiance 0: no ray
    float tMax;
    uint group;                      // of the light
};

// Origin of a ray to local direction wi.
vec3 leaveSurface(ShadingPoint p, vec3 wi) { return p.position + p.ng * (wi.z < 0.0 ? -p.offset : p.offset); }

void storeShadowItem(uint slot, uint path, ShadowItem item) {
    storeStateFloat(kShadowOrigin, slot, vec4(item.origin, uintBitsToFloat(path)));
    storeStateFloat(kShadowTarget, slot, vec4(item.target, item.tMax));
    storeStateFloat(kShadowRadiance, slot, vec4(item.radiance, uintBitsToFloat(item.group)));
}
