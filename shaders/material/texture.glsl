// Textures fetched, decoded and filtered by our own code: fixed-function weights may have 4 bits only.

int wrapCoordinate(int i, int size, uint mode) {
    if (mode == kWrapClamp) return clamp(i, 0, size - 1);
    int period = mode == kWrapMirror ? 2 * size : size;
    int r = i - period * int(floor(float(i) / float(period)));
    r -= period * int(floor(float(r) / float(period)));        // far out the quotient is off by more than one
    r = r < 0 ? r + period : (r >= period ? r - period : r);   // the quotient was rounded
    return r < size ? r : 2 * size - 1 - r;
}

// The four texels around a point, as indices into the texel array: left and right above, left and right below; and the
// weights of the right and of the lower ones.
struct TexelFootprint {
    uvec4 texels;
    vec2 weight;
};

// (u, v) is transformed, then wrapped texel by texel.
TexelFootprint textureFootprint(TextureRecord t, vec2 uv) {
    ivec2 size = ivec2(t.size & 0xffffu, t.size >> 16u);
    vec2 p = vec2(dot(t.rowU.xyz, vec3(uv, 1.0)), dot(t.rowV.xyz, vec3(uv, 1.0))) * vec2(size);
    bool nearest = (t.flags & kTextureNearest) != 0u;
    vec2 corner = nearest ? floor(p) : floor(p - 0.5);
    uint modeS = (t.flags >> kTextureWrapSShift) & kTextureWrapMask, modeT = (t.flags >> kTextureWrapTShift) & kTextureWrapMask;
    ivec2 i = ivec2(clamp(corner, vec2(-1e9), vec2(1e9)));
    uint x0 = uint(wrapCoordinate(i.x, size.x, modeS)), x1 = uint(wrapCoordinate(i.x + 1, size.x, modeS));
    uint y0 = uint(wrapCoordinate(i.y, size.y, modeT)), y1 = uint(wrapCoordinate(i.y + 1, size.y, modeT));
    uvec4 texels = uvec4(y0, y0, y1, y1) * uint(size.x) + uvec4(x0, x1, x0, x1);
    return TexelFootprint(t.texels + texels * t.stride, nearest ? vec2(0.0) : p - 0.5 - corner);
}

vec4 decodeTexel(uint texel, bool srgb) {
    vec4 c = unpackUnorm4x8(texel);
    return srgb ? vec4(srgbToLinear(c.rgb), c.a) : c;
}

vec4 filterTexels(uvec4 texels, vec2 weight, bool srgb) {
    vec4 above = mix(decodeTexel(texels.x, srgb), decodeTexel(texels.y, srgb), weight.x);
    vec4 below = mix(decodeTexel(texels.z, srgb), decodeTexel(texels.w, srgb), weight.x);
    return mix(above, below, weight.y);
}

uvec4 texelWord(uint texel) { return sceneWord(scene.texels + (texel >> 2u)); }

// The texture at (u, v): transformed, wrapped, decoded, filtered.
vec4 sampleTexture(TextureRecord t, vec2 uv) {
    TexelFootprint f = textureFootprint(t, uv);
    uvec4 texels;
    for (uint i = 0u; i < 4u; ++i) texels[i] = texelWord(f.texels[i])[f.texels[i] & 3u];
    return filterTexels(texels, f.weight, (t.flags & kTextureSrgb) != 0u);
}
