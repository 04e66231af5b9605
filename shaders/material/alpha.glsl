// Alpha test of one crossing: MASK compares, BLEND lets chance decide by a hash, so that the segments of a path
// decide independently and the order of traversal does not matter. [estimator.md, step 1]
AlphaKey makeAlphaKey(SampleId id, uint bounce, uint kind) {
    return AlphaKey(hash(uvec4(id.pixel, id.index, id.seed, 2u * bounce + kind)).x);
}

bool alphaAccepts(AlphaKey key, uint flags, uvec3 vertices, uint instance, uint primitive, vec2 b12) {
    MaterialRecord m = loadMaterial(flags >> kTriangleMaterialShift);
    SurfaceUv s = interpolateUv(vertices, loadVertex(vertices.x), loadVertex(vertices.y), loadVertex(vertices.z),
                                vec3(1.0 - b12.x - b12.y, b12));
    float alpha = surfaceBaseColor(m, s, surfaceTexture(m.baseColorTexture, s)).a;
    if ((m.flags & kMaterialAlphaMask) != 0u) return alpha >= m.alphaCutoff;
    return toUnit(hash(uvec4(key.bits, instance, primitive, kSaltAlpha)).x) < alpha;
}
