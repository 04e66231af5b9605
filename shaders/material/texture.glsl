// Textures fetched, decoded and filtered by our own code: fixed-function weights may have 4 bits only.

int wrapCoordinate(int i, int size, uint mode) {
    if (mode == kWrapClamp) return clamp(i, 0, size - 1);
    int period = mode == kWrapMirror ? 2 * size : size;
    int r = i - period * int(floor(float(i) / float(period)));
    r -= period * int(floor(float(r) / float(period)));        // far out the quotient is off by more than one
    r = r < 0 ? r + period : (r >= period ? r - period : r);   // the quotient was rounded
    return r < size ? r : 2 * size - 1 - r;
}

vec4 loadTexel(TextureRecord t, int x, int y) {
    uint texel = t.texels + uint(y) * (t.size & 0xffffu) + uint(x);
    vec4 c = unpackUnorm4x8(sceneWord(scene.texels + (texel >> 2u))[texel & 3u]);
    if ((t.flags & kTextureSrgb) != 0u) c.rgb = srgbToLinear(c.rgb);
    return c;
}

// The texture at (u, v): transformed, wrapped, decoded, filtered.
vec4 sampleTexture(TextureRecord t, vec2 uv) {
    ivec2 size = ivec2(t.size & 0xffffu, t.size >> 16u);
    vec2 p = vec2(dot(t.rowU.xyz, vec3(uv, 1.0)), dot(t.rowV.xyz, vec3(uv, 1.0))) * vec2(size);
    bool nearest = (t.flags & kTextureNearest) != 0u;
    vec2 corner = nearest ? floor(p) : floor(p - 0.5);
    vec2 w = nearest ? vec2(0.0) : p - 0.5 - corner;
    uint modeS = (t.flags >> kTextureWrapSShift) & kTextureWrapMask, modeT = (t.flags >> kTextureWrapTShift) & kTextureWrapMask;
    ivec2 i = ivec2(clamp(corner, vec2(-1e9), vec2(1e9)));
    int x0 = wrapCoordinate(i.x, size.x, modeS), x1 = wrapCoordinate(i.x + 1, size.x, modeS);
    int y0 = wrapCoordinate(i.y, size.y, modeT), y1 = wrapCoordinate(i.y + 1, size.y, modeT);
    vec4 top = mix(loadTexel(t, x0, y0), loadTexel(t, x1, y0), w.x);
    vec4 bottom = mix(loadTexel(t, x0, y1), loadTexel(t, x1, y1), w.x);
    return mix(top, bottom, w.y);
}
