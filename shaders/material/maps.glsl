// All maps of a material at a surface point, set by set: maps that lie side by side cost the loads of one.

struct MaterialMaps {
    vec4 baseColor, metallicRoughness, emissive;   // white where absent
    vec4 normal;                                   // straight up where absent
};

// Filters the map of `role` where the set holds it; `component` is where its texels lie in the words of the footprint.
void sampleRole(uint roles, uint role, bool srgb, uvec4 words[4], TexelFootprint f, inout uint component, inout vec4 map) {
    bool held = (roles & (1u << role)) != 0u;
    if ((kSceneMaps & (1u << role)) == 0u || !held) return;
    uvec4 texels, at = (f.texels + component) & 3u;
    for (uint i = 0u; i < 4u; ++i) texels[i] = words[i][at[i]];
    map = filterTexels(texels, f.weight, srgb);
    ++component;
}

MaterialMaps sampleMaterialMaps(MaterialRecord m, SurfaceUv s) {
    MaterialMaps maps = MaterialMaps(vec4(1.0), vec4(1.0), vec4(1.0), vec4(0.5, 0.5, 1.0, 1.0));
    if (kSceneMaps == 0u) return maps;
    uvec4 textures = uvec4(m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture, m.emissiveTexture);
    for (uint i = 0u; i < kMapSets; ++i) {
        uint roles = (m.flags >> (kMaterialMapSetShift + kMapRoles * i)) & ((1u << kMapRoles) - 1u), component = 0u;
        if (roles == 0u) continue;
        TextureRecord t = loadTexture(textures[findLSB(roles)]);
        TexelFootprint f = textureFootprint(t, (t.flags & kTextureUv1) != 0u ? s.uv1 : s.uv0);
        uvec4 words[4];
        for (uint c = 0u; c < 4u; ++c) words[c] = texelWord(f.texels[c]);
        sampleRole(roles, kMapBaseColor, true, words, f, component, maps.baseColor);
        sampleRole(roles, kMapMetallicRoughness, false, words, f, component, maps.metallicRoughness);
        sampleRole(roles, kMapNormal, false, words, f, component, maps.normal);
        sampleRole(roles, kMapEmissive, true, words, f, component, maps.emissive);
    }
    return maps;
}
