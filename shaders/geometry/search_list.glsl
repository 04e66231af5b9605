// Rays against triangles, and against all of a scene that has few.

struct Hit {
    float t;
    float b1, b2;
    uint slot;       // of the triangle, or kNone
    uint instance;   // 0 where nothing is instanced
    uint primitive;
};

// What the stochastic alpha test of one segment depends on. [estimator.md, step 1]
struct AlphaKey {
    uint bits;   // hash of pixel, sample, seed and 2 bounce + kind
};

// Confirms a hit on a triangle with alpha.
bool alphaAccepts(AlphaKey key, uint flags, uvec3 vertices, uint instance, uint primitive, vec2 b12);

// Tests triangle `slot`, whose first words are in `t`; returns whether it became the hit.
bool testTriangle(ShearedRay ray, inout Hit hit, TriangleRecord t, uint slot, uint instance, AlphaKey key) {
    vec4 r = intersectTriangle(ray, t.v0, t.v1, t.v2);
    bool first = t.primitive < hit.primitive || (t.primitive == hit.primitive && instance < hit.instance);  // of ties
    bool nearer = r.x < hit.t || (r.x == hit.t && first), seen = r.w > 0.0 || (t.flags & kTriangleSingleSided) == 0u;
    bool met = r.w != 0.0 && r.x > 0.0 && nearer && seen;
    vec2 b12 = vec2(r.z, 1.0 - r.y - r.z);
    if (kHasAlpha != 0u && met && (t.flags & kTriangleHasAlpha) != 0u) {
        uvec3 vertices = sceneWord(scene.triangles + slot * 4u + 3u).xyz;
        met = alphaAccepts(key, t.flags, vertices, instance, t.primitive, b12);
    }
    if (met) hit = Hit(r.x, b12.x, b12.y, slot, instance, t.primitive);
    return met;
}

// Few triangles are all tested, in the order of the list: none is loaded twice, and where invocations run in lockstep
// they do nothing that only some of them need. Unrolled, so that every load is of a place known to the driver.
Hit searchList(vec3 origin, vec3 d, float tMax, AlphaKey key) {
    ShearedRay ray = shearRay(origin, d);
    Hit hit = Hit(tMax, 0.0, 0.0, kNone, 0u, 0u);
    [[unroll]] for (uint i = 0u; i < kListTriangles; ++i) testTriangle(ray, hit, frame.list[i], i, 0u, key);
    return hit;
}
