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

uvec2 searchCost = uvec2(0u);   // integrator cost: nodes opened, triangles tested

// Confirms a hit on a triangle with alpha.
bool alphaAccepts(AlphaKey key, uint flags, uvec3 vertices, uint instance, uint primitive, vec2 b12);

struct Traversal {
    SlabRay slab;
    ShearedRay sheared;
    Hit hit;
};

// Tests triangle `slot`; returns whether it became the hit.
bool testTriangle(inout Traversal s, uint slot, uint instance, AlphaKey key) {
    if (kIntegrator == kIntegratorCost) ++searchCost.y;
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

vec3 transformPoint(vec4 rows[3], vec3 p) {
    return vec3(dot(rows[0], vec4(p, 1.0)), dot(rows[1], vec4(p, 1.0)), dot(rows[2], vec4(p, 1.0)));
}
vec3 transformVector(vec4 rows[3], vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)); }

void setRay(inout Traversal s, vec3 origin, vec3 d) {
    s.slab = makeSlabRay(origin, d);
    s.sheared = shearRay(origin, d);
}

// Walks the tree. Finds the closest hit in 0 < t < tMax (a hit at tMax itself does not count), or with
// `anyHit` stops at the first. slot is kNone where nothing is met. One loop, each round a node or an item: where
// invocations run in lockstep an inner loop over items would wait for the longest list at every node.
Hit traverse(vec3 origin, vec3 d, float tMax, AlphaKey key, bool anyHit) {
    Traversal s;
    s.hit = Hit(tMax, 0.0, 0.0, kNone, 0u, 0u);
    setRay(s, origin, d);
    uvec2 stack[kStackSize];
    uint depth = 0u, meshDepth = 0u, instance = 0u;
    bool inMesh = kHasInstances == 0u;
    uvec2 nodes = uvec2(scene.rootNode, 0x80000000u);   // first child, bits of the children still to visit
    uvec2 items = uvec2(0u);                            // first item, bits of the items still to test
    for (;;) {
        if (items.y == 0u && nodes.y > 0x00ffffffu) {
            uint bit = uint(findMSB(nodes.y)), slot = (bit - 24u) ^ s.slab.octant;
            uint node = nodes.x + bitCount(nodes.y & ((1u << slot) - 1u) & 0xffu);
            nodes.y &= ~(1u << bit);
            if (nodes.y > 0x00ffffffu) stack[depth++] = nodes;
            WideNode n = loadNode(node);
            if (kIntegrator == kIntegratorCost) ++searchCost.x;
            uint hits = intersectNode(s.slab, n, s.hit.t);
            nodes = uvec2(n.childBase, (hits & 0xff000000u) | (n.exponents >> 24u));
            items = uvec2(n.itemBase, hits & 0x00ffffffu);
        }
        if (items.y != 0u) {
            uint item = items.x + uint(findLSB(items.y));
            items.y &= items.y - 1u;
            if (inMesh) {
                if (testTriangle(s, item, instance, key) && anyHit) break;
            } else {
                if (nodes.y > 0x00ffffffu) stack[depth++] = nodes;
                if (items.y != 0u) stack[depth++] = items;   // the group's other instances come after this one
                InstanceRecord r = loadInstance(item);
                setRay(s, transformPoint(r.objectFromWorld, origin), transformVector(r.objectFromWorld, d));
                instance = item;
                inMesh = true;
                meshDepth = depth;
                nodes = uvec2(r.rootNode, 0x80000000u);
                items = uvec2(0u);
            }
        }
        if (items.y == 0u && nodes.y <= 0x00ffffffu) {
            if (kHasInstances != 0u && inMesh && depth == meshDepth) {
                inMesh = false;
                instance = 0u;
                setRay(s, origin, d);
            }
            if (depth == 0u) break;
            uvec2 top = stack[--depth];
            if (top.y > 0x00ffffffu) nodes = top;
            else items = top;
        }
    }
    return s.hit;
}
