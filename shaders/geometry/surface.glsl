// Attributes interpolated at a hit.

struct SurfaceUv {
    vec2 uv0, uv1;
    vec4 color;   // COLOR_0, 1 where absent
};

SurfaceUv interpolateUv(uvec3 vertices, VertexRecord a, VertexRecord b, VertexRecord c, vec3 w) {
    SurfaceUv s;
    s.uv0 = w.x * vec2(a.u0, a.v0) + w.y * vec2(b.u0, b.v0) + w.z * vec2(c.u0, c.v0);
    s.uv1 = vec2(0.0);
    s.color = vec4(1.0);
    if (kHasVertexExtras != 0u) {
        VertexExtra ea = loadVertexExtra(vertices.x), eb = loadVertexExtra(vertices.y), ec = loadVertexExtra(vertices.z);
        s.uv1 = w.x * vec2(ea.u1, ea.v1) + w.y * vec2(eb.u1, eb.v1) + w.z * vec2(ec.u1, ec.v1);
        s.color = w.x * vec4(unpackUnorm2x16(ea.colorRG), unpackUnorm2x16(ea.colorBA)) +
                  w.y * vec4(unpackUnorm2x16(eb.colorRG), unpackUnorm2x16(eb.colorBA)) +
                  w.z * vec4(unpackUnorm2x16(ec.colorRG), unpackUnorm2x16(ec.colorBA));
    }
    return s;
}

// The texture `index` at the surface, white where index is kNone.
vec4 surfaceTexture(uint index, SurfaceUv s) {
    if (kSceneMaps == 0u || index == kNone) return vec4(1.0);
    TextureRecord t = loadTexture(index);
    vec2 uv = (t.flags & kTextureUv1) != 0u ? s.uv1 : s.uv0;
    return sampleTexture(t, uv);
}

// Base colour with the texel of its map.
vec4 surfaceBaseColor(MaterialRecord m, SurfaceUv s, vec4 texel) {
    vec4 c = m.baseColor * texel;
    if (kHasVertexExtras != 0u && (m.flags & kMaterialVertexColor) != 0u) c *= s.color;
    return c;
}
