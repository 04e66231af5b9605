// Closest hit and occlusion through one or two levels of the compressed wide BVH. [Ylitie 17]

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

const uint kStackSize = 32u;

// Confirms a hit on a triangle with alpha.
bool alphaAccepts(AlphaKey key, uint flags, uvec3 vertices, uint instance, uint primitive, vec2 b12);

struct Traversal {
    SlabRay slab;
    ShearedRay sheared;
    Hit hit;
};

// Tests triangle `slot`; returns whether it became the hit.
bool testTriangle(inout Traversal s, uint slot, uint instance, AlphaKey key) {
    uint base = scene.triangles + slot * 4u;
    uvec4 w0 = sceneWord(base), w1 = sceneWord(base + 1u), w2 = sceneWord(base + 2u);
    vec4 r = intersectTriangle(s.sheared, uintBitsToFloat(w0.xyz), uintBitsToFloat(w1.xyz), uintBitsToFloat(w2.xyz));
    bool first = w2.w < s.hit.primitive || (w2.w == s.hit.primitive && instance < s.hit.instance);  // settles ties
    bool nearer = r.x < s.hit.t || (r.x == s.hit.t && first);
    if (r.w == 0.0 || r.x <= 0.0 || !nearer) return false;
    if (r.w < 0.0 && (w0.w & kTriangleSingleSided) != 0u) return false;
    vec2 b12 = vec2(r.z, 1.0 - r.y - r.z);
    if (kHasAlpha != 0u && (w0.w & kTriangleHasAlpha) != 0u) {
        if (!alphaAccepts(key, w0.w, sceneWord(base + 3u).xyz, instance, w2.w, b12)) return false;
    }
    s.hit = Hit(r.x, b12.x, b12.y, slot, instance, w2.w);
    return true;
}

void setRay(inout Traversal s, vec3 origin, vec3 d) {
    s.slab = makeSlabRay(origin, d);
    s.sheared = shearRay(origin, d);
}

// Walks the tree. Finds the closest hit in 0 < t < tMax (a hit at tMax itself does not count), or with
// `anyHit` stops at the first. slot is kNone where nothing is met.
Hit traverse(vec3 origin, vec3 d, float tMax, AlphaKey key, bool anyHit) {
    Traversal s;
    s.hit = Hit(tMax, 0.0, 0.0, kNone, 0u, 0u);
    setRay(s, origin, d);
    uvec2 stack[kStackSize];
    uint depth = 0u, meshDepth = 0u, instance = 0u;
    bool inMesh = kHasInstances == 0u;
    uvec2 nodes = uvec2(scene.rootNode, 0x80000000u);
    uvec2 items = uvec2(0u);
    for (;;) {
        if (nodes.y > 0x00ffffffu) {
            uint bit = uint(findMSB(nodes.y));
            uint slot = (bit - 24u) ^ s.slab.octant;
            uint rank = bitCount(nodes.y & ((1u << slot) - 1u) & 0xffu);
            uint node = nodes.x + rank;
            nodes.y &= ~(1u << bit);
            if (nodes.y > 0x00ffffffu) stack[depth++] = nodes;
            WideNode n = loadNode(node);
            uint hits = intersectNode(s.slab, n, s.hit.t);
            nodes = uvec2(n.childBase, (hits & 0xff000000u) | (n.exponents >> 24u));
            items = uvec2(n.itemBase, hits & 0x00ffffffu);
        } else {
            items = nodes;
            nodes = uvec2(0u);
        }
        while (items.y != 0u) {
            uint bit = uint(findLSB(items.y));
            items.y &= items.y - 1u;
            uint item = items.x + bit;
            if (inMesh) {
                if (testTriangle(s, item, instance, key) && anyHit) {
                    items.y = 0u;
                    nodes.y = 0u;
                    depth = 0u;
                }
            } else {
                if (items.y != 0u) stack[depth++] = items;   // what is left of this group comes after the mesh
                if (nodes.y > 0x00ffffffu) stack[depth++] = nodes;
                InstanceRecord r = loadInstance(item);
                setRay(s, vec3(dot(r.objectFromWorld[0], vec4(origin, 1.0)), dot(r.objectFromWorld[1], vec4(origin, 1.0)),
                               dot(r.objectFromWorld[2], vec4(origin, 1.0))),
                       vec3(dot(r.objectFromWorld[0].xyz, d), dot(r.objectFromWorld[1].xyz, d),
                            dot(r.objectFromWorld[2].xyz, d)));
                instance = item;
                inMesh = true;
                meshDepth = depth;
                nodes = uvec2(r.rootNode, 0x80000000u);
                break;
            }
        }
        if (nodes.y <= 0x00ffffffu) {
            if (kHasInstances != 0u && inMesh && depth == meshDepth) {
                inMesh = false;
                instance = 0u;
                setRay(s, origin, d);
            }
            if (depth == 0u) break;
            nodes = stack[--depth];
        }
    }
    return s.hit;
}
