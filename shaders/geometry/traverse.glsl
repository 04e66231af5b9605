// Closest hit and occlusion through one or two levels of the compressed wide BVH. [Ylitie 17]
#include "geometry/search_list.glsl"

// What is left to visit above: children not yet opened, or items not yet tested. Where invocations run in lockstep on a
// CPU, an index that differs between them costs a scalar access each, and all slots of a shallow stack cost less.
const bool kStackSelected = kStackEntries <= 12u;
uvec2 stack[kStackEntries];
uint stackDepth;

void pushIf(bool wanted, uvec2 entry) {
    if (kStackSelected) {
        [[unroll]] for (uint i = 0u; i < kStackEntries; ++i)
            if (wanted && stackDepth == i) stack[i] = entry;
        stackDepth += wanted ? 1u : 0u;
    } else if (wanted) {
        stack[stackDepth++] = entry;
    }
}

uvec2 pop() {
    --stackDepth;
    if (!kStackSelected) return stack[stackDepth];
    uvec2 top = stack[0];
    [[unroll]] for (uint i = 1u; i < kStackEntries; ++i)
        if (stackDepth == i) top = stack[i];
    return top;
}

uvec2 searchCost = uvec2(0u);   // integrator cost: nodes opened, triangles tested

struct Traversal {
    SlabRay slab;
    ShearedRay sheared;
    Hit hit;
};

vec3 transformPoint(vec4 rows[3], vec3 p) {
    return vec3(dot(rows[0], vec4(p, 1.0)), dot(rows[1], vec4(p, 1.0)), dot(rows[2], vec4(p, 1.0)));
}
vec3 transformVector(vec4 rows[3], vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)); }

void setRay(inout Traversal s, vec3 origin, vec3 d) {
    s.slab = makeSlabRay(origin, d);
    s.sheared = shearRay(origin, d);
}

// Opens the nearest of `nodes` and keeps the rest for later: then `nodes` and `items` are what the ray meets in it.
void openNext(SlabRay ray, float tMax, inout uvec2 nodes, inout uvec2 items) {
    uint bit = uint(findMSB(nodes.y)), slot = (bit - 24u) ^ ray.octant;
    uint node = nodes.x + bitCount(nodes.y & ((1u << slot) - 1u) & 0xffu);
    nodes.y &= ~(1u << bit);
    pushIf(nodes.y > 0x00ffffffu, nodes);
    WideNode n = loadNode(node);
    if (kIntegrator == kIntegratorCost) ++searchCost.x;
    uint hits = intersectNode(ray, n, tMax);
    nodes = uvec2(n.childBase, (hits & 0xff000000u) | (n.exponents >> 24u));
    items = uvec2(n.itemBase, hits & 0x00ffffffu);
}

// Walks the tree; with `anyHit` stops at the first hit. One loop, each round a node or an item: where
// invocations run in lockstep an inner loop over items would wait for the longest list at every node.
Hit walkTree(vec3 origin, vec3 d, float tMax, AlphaKey key, bool anyHit) {
    Traversal s;
    s.hit = Hit(tMax, 0.0, 0.0, kNone, 0u, 0u);
    setRay(s, origin, d);
    stackDepth = 0u;
    uint meshDepth = 0u, instance = 0u;
    bool inMesh = false;   // looked at only where there are instances: drivers do not find that it never changes
    uvec2 nodes = uvec2(scene.rootNode, 0x80000000u);   // first child, bits of the children still to visit
    uvec2 items = uvec2(0u);                            // first item, bits of the items still to test
    for (;;) {
        if (items.y == 0u && nodes.y > 0x00ffffffu) openNext(s.slab, s.hit.t, nodes, items);
        if (items.y != 0u) {
            uint item = items.x + uint(findLSB(items.y));
            items.y &= items.y - 1u;
            if (kHasInstances == 0u || inMesh) {
                if (kIntegrator == kIntegratorCost) ++searchCost.y;
                if (testTriangle(s.sheared, s.hit, loadTriangle(item), item, instance, key) && anyHit) break;
            } else {
                pushIf(nodes.y > 0x00ffffffu, nodes);
                pushIf(items.y != 0u, items);   // the group's other instances come after this one
                InstanceRecord r = loadInstance(item);
                setRay(s, transformPoint(r.objectFromWorld, origin), transformVector(r.objectFromWorld, d));
                instance = item;
                inMesh = true;
                meshDepth = stackDepth;
                nodes = uvec2(r.rootNode, 0x80000000u);
                items = uvec2(0u);
            }
        }
        if (items.y == 0u && nodes.y <= 0x00ffffffu) {
            if (kHasInstances != 0u && inMesh && stackDepth == meshDepth) {
                inMesh = false;
                instance = 0u;
                setRay(s, origin, d);
            }
            if (stackDepth == 0u) break;
            uvec2 top = pop();
            if (kHasInstances == 0u || top.y > 0x00ffffffu) nodes = top;
            else items = top;
        }
    }
    return s.hit;
}

// The closest hit in 0 < t < tMax (a hit at tMax itself does not count), or with `anyHit` any. slot is kNone where
// nothing is met.
Hit traverse(vec3 origin, vec3 d, float tMax, AlphaKey key, bool anyHit) {
    if (kListTriangles != 0u) return searchList(origin, d, tMax, key);
    return walkTree(origin, d, tMax, key, anyHit);
}
