// Box tests of the compressed 8-wide BVH. [Ylitie 17]
// The distance to plane q is q (2^e / d) + (origin - o) / d. Boxes grow by kPad of the reach of the node, its largest
// distance from the ray's origin along an axis: that covers the rounding of this sum (3 roundings of numbers up to the
// reach) and of the sheared triangle test [Woop 13, app. A: 5 ulps]. The builder checked planes as rounded to float at
// their own magnitude, at most the reach above that of o: `decoding` covers it. So no box of a hit is missed.

const float kPad = 1.1920929e-6;   // 20 x 2^-24

struct SlabRay {
    vec3 origin, inverse;
    float decoding;   // what boxes grow by for the rounding of their planes: an ulp of the origin's coordinates
    uint octant;   // 7 - (bit 0: x, 1: y, 2: z negative): priority of a child is slot ^ octant
};

SlabRay makeSlabRay(vec3 origin, vec3 d) {
    const float tiny = 1e-20;  // a zero component would make 0 x infinity; the pad outweighs the difference
    vec3 safe = mix(d, vec3(d.x < 0.0 ? -tiny : tiny, d.y < 0.0 ? -tiny : tiny, d.z < 0.0 ? -tiny : tiny),
                    lessThan(abs(d), vec3(tiny)));
    uint negative = (d.x < 0.0 ? 1u : 0u) | (d.y < 0.0 ? 2u : 0u) | (d.z < 0.0 ? 4u : 0u);
    vec3 size = abs(origin);
    return SlabRay(origin, 1.0 / safe, 1.1920929e-7 * max(size.x, max(size.y, size.z)), 7u - negative);
}

// Distances along the ray to the planes of a node's grid: cell a step, near and far of plane 0, pad included.
struct GridRay {
    vec3 cell, near, far;
};

vec4 byteFloats(uint word) {
    return vec4(float(word & 0xffu), float((word >> 8u) & 0xffu), float((word >> 16u) & 0xffu), float(word >> 24u));
}

// Four children: the bits they contribute to the hit mask.
uint intersectFour(GridRay g, uvec3 lo, uvec3 hi, bvec3 negative, uint meta, uint octant4, float tMax) {
    uvec3 nearWord = mix(lo, hi, negative), farWord = mix(hi, lo, negative);
    vec4 tNear = max(max(byteFloats(nearWord.x) * g.cell.x + g.near.x, byteFloats(nearWord.y) * g.cell.y + g.near.y),
                     max(byteFloats(nearWord.z) * g.cell.z + g.near.z, vec4(0.0)));
    vec4 tFar = min(min(byteFloats(farWord.x) * g.cell.x + g.far.x, byteFloats(farWord.y) * g.cell.y + g.far.y),
                    min(byteFloats(farWord.z) * g.cell.z + g.far.z, vec4(tMax)));
    // Inner children (meta 001xxxxx, xxxxx >= 24) move to their priority; leaves keep their item bits.
    uint inner4 = (meta & (meta << 1u)) & 0x10101010u;
    uint index4 = meta ^ (octant4 & ((inner4 >> 4u) * 0xffu));
    uvec4 shift = uvec4(0u, 8u, 16u, 24u);
    uvec4 bits = ((uvec4(meta) >> (shift + 5u)) & 7u) << ((uvec4(index4) >> shift) & 31u);
    uvec4 hits = mix(uvec4(0u), bits, lessThanEqual(tNear, tFar));
    return hits.x | hits.y | hits.z | hits.w;
}

// Hit mask of a node: bits 24 to 31 inner children by priority, bits 0 to 23 leaf items.
uint intersectNode(SlabRay ray, WideNode n, float tMax) {
    vec3 cell = uintBitsToFloat((uvec3(n.exponents, n.exponents >> 8u, n.exponents >> 16u) & 0xffu) << 23u);
    vec3 low = n.origin - ray.origin, extent = max(abs(low), abs(low + 255.0 * cell));
    vec3 pad = abs(ray.inverse) * (kPad * max(extent.x, max(extent.y, extent.z)) + ray.decoding);
    vec3 corner = low * ray.inverse;
    GridRay g = GridRay(cell * ray.inverse, corner - pad, corner + pad);
    bvec3 negative = lessThan(ray.inverse, vec3(0.0));
    uint octant4 = ray.octant * 0x01010101u;
    return intersectFour(g, uvec3(n.loX0, n.loY0, n.loZ0), uvec3(n.hiX0, n.hiY0, n.hiZ0), negative, n.meta0, octant4,
                         tMax) |
           intersectFour(g, uvec3(n.loX1, n.loY1, n.loZ1), uvec3(n.hiX1, n.hiY1, n.hiZ1), negative, n.meta1, octant4,
                         tMax);
}
