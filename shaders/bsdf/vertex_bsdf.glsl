// The BSDF of a group other than glTF's at a path vertex.
#define VertexBsdf SurfaceBsdf

SurfaceBsdf makeVertexBsdf(ShadingPoint p, vec3 wo) {
    MaterialRecord m = p.material;
    vec3 color = p.maps.baseColor.rgb;
    if (kHasVertexExtras != 0u && (m.flags & kMaterialVertexColor) != 0u) color *= p.uv.color.rgb;
    uint model = (m.flags >> kMaterialModelShift) & kMaterialModelMask;
    return makeSurfaceBsdf(loadBsdf(p.materialIndex), model, color, p.maps.metallicRoughness.g, p.front, wo);
}

// The x axis of anisotropic lobes follows the surface's tangent, where it has one.
ShadingFrame makeVertexFrame(ShadingPoint p) {
    vec3 n = p.frame.n, t = p.tangent - n * dot(n, p.tangent);
    float length2 = dot(t, t);
    if (length2 <= 0.0) return p.frame;
    t *= inversesqrt(length2);
    return ShadingFrame(t, cross(n, t), n);
}
