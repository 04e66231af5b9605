// Loads of the records of shared/layout.h, word by word.
TriangleRecord loadTriangle(uint slot) {
    uint base = scene.triangles + slot * 4u;
    uvec4 w0 = sceneWord(base), w1 = sceneWord(base + 1u), w2 = sceneWord(base + 2u), w3 = sceneWord(base + 3u);
    return TriangleRecord(uintBitsToFloat(w0.xyz), w0.w, uintBitsToFloat(w1.xyz), w1.w, uintBitsToFloat(w2.xyz), w2.w,
                          w3.x, w3.y, w3.z, w3.w);
}

VertexRecord loadVertex(uint index) {
    uvec4 w = sceneWord(scene.vertices + index);
    return VertexRecord(w.x, uintBitsToFloat(w.y), uintBitsToFloat(w.z), w.w);
}

VertexExtra loadVertexExtra(uint index) {
    uvec4 w = sceneWord(scene.vertexExtras + index);
    return VertexExtra(uintBitsToFloat(w.x), uintBitsToFloat(w.y), w.z, w.w);
}

InstanceRecord loadInstance(uint index) {
    uint base = scene.instances + index * 7u;
    InstanceRecord r;
    for (uint i = 0u; i < 3u; ++i) {
        r.objectFromWorld[i] = sceneWordFloat(base + i);
        r.worldFromObject[i] = sceneWordFloat(base + 3u + i);
    }
    uvec4 w = sceneWord(base + 6u);
    r.rootNode = w.x;
    r.object = w.y;
    r.pad0 = w.z;
    r.pad1 = w.w;
    return r;
}

// The mesh instance that a triangle, met through `instance`, is of.
uint objectOf(uint triangle, uint instance) {
    uint object = kHasInstances != 0u ? sceneWord(scene.instances + instance * 7u + 6u).y : kNone;
    return object != kNone ? object : sceneWord(scene.triangles + triangle * 4u + 3u).w;
}

MaterialRecord loadMaterial(uint index) {
    uint base = scene.materials + index * 4u;
    vec4 w0 = sceneWordFloat(base), w1 = sceneWordFloat(base + 1u);
    uvec4 w2 = sceneWord(base + 2u), w3 = sceneWord(base + 3u);
    return MaterialRecord(w0, w1.xyz, w1.w, uintBitsToFloat(w2.x), uintBitsToFloat(w2.y), uintBitsToFloat(w2.z), w2.w,
                          w3.x, w3.y, w3.z, w3.w);
}

BsdfRecord loadBsdf(uint index) {
    uint base = scene.bsdfs + index * 6u;
    vec4 w0 = sceneWordFloat(base), w1 = sceneWordFloat(base + 1u), w2 = sceneWordFloat(base + 2u),
         w3 = sceneWordFloat(base + 3u), w4 = sceneWordFloat(base + 4u);
    uvec4 w5 = sceneWord(base + 5u);
    return BsdfRecord(w0.xyz, w0.w, w1.xyz, w1.w, w2.xyz, w2.w, w3.xyz, w3.w, w4.xyz, w4.w, w5.x, w5.y,
                      uintBitsToFloat(w5.z), uintBitsToFloat(w5.w));
}

// Of a dielectric: what the medium behind it absorbs, 1/m.
vec3 loadAbsorption(uint material) { return sceneWordFloat(scene.bsdfs + material * 6u + 1u).xyz; }

FilterCell loadFilterCell(uint index) {
    vec4 w = sceneWordFloat(scene.filterTable + index);
    return FilterCell(w.x, w.y, w.z, w.w);
}

TextureRecord loadTexture(uint index) {
    uint base = scene.textures + index * 3u;
    uvec4 w0 = sceneWord(base);
    TextureRecord r = TextureRecord(w0.x, w0.y, w0.z, w0.w, vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0, 1.0, 0.0, 0.0));
    if (kHasTransforms != 0u) {
        r.rowU = sceneWordFloat(base + 1u);
        r.rowV = sceneWordFloat(base + 2u);
    }
    return r;
}

LightRecord loadLight(uint index) {
    uint base = scene.lights + index * 4u;
    uvec4 w0 = sceneWord(base);
    vec4 w1 = sceneWordFloat(base + 1u), w2 = sceneWordFloat(base + 2u);
    uvec4 w3 = sceneWord(base + 3u);
    return LightRecord(uintBitsToFloat(w0.xyz), w0.w, w1.xyz, w1.w, w2.xyz, w2.w, uintBitsToFloat(w3.xyz), w3.w);
}

WideNode loadNode(uint index) {
    uint base = scene.nodes + index * 5u;
    uvec4 w0 = sceneWord(base), w1 = sceneWord(base + 1u), w2 = sceneWord(base + 2u), w3 = sceneWord(base + 3u),
          w4 = sceneWord(base + 4u);
    return WideNode(uintBitsToFloat(w0.xyz), w0.w, w1.x, w1.y, w1.z, w1.w, w2.x, w2.y, w2.z, w2.w, w3.x, w3.y, w3.z,
                    w3.w, w4.x, w4.y, w4.z, w4.w);
}
