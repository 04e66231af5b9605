// Box tests of the compressed 8-wide BVH. [Ylitie 17]
// Planes are decoded as origin + q 2^e, exactly as the builder checked them, before the ray's origin is
// subtracted. Boxes grow by the rounding of the sheared triangle test [Woop 13, app. A] and far distances by that of
// the slab test [Ize 13], so that no box of a hit is missed.

const float kFarSlack = 1.0000004;  // 1 + 2 gamma(3)

struct SlabRay {
    vec3 origin, inverse;
    uint octant;   // 7 - (bit 0: x, 1: y, 2: z negative): priority of a child is slot ^ octant
};

SlabRay makeSlabRay(vec3 origin, vec3 d) {
    const float tiny = 1e-30;  // a zero component would make 0 x infinity
    vec3 safe = mix(d, vec3(d.x < 0.0 ? -tiny : tiny, d.y < 0.0 ? -tiny : tiny, d.z < 0.0 ? -tiny : tiny),
                    lessThan(abs(d), vec3(tiny)));
    uint negative = (d.x < 0.0 ? 1u : 0u) | (d.y < 0.0 ? 2u : 0u) | (d.z < 0.0 ? 4u : 0u);
    return SlabRay(origin, 1.0 / safe, 7u - negative);
}

vec4 byteFloats(uint word) {
    return vec4(float(word & 0xffu), float((word >> 8u) & 0xffu), float((word >> 16u) & 0xffu), float(word >> 24u));
}

// Four children (half = 0 or 1): the bits they contribute to the hit mask.
uint intersectHalf(SlabRay ray, vec3 p, vec3 cell, vec3 pad, uvec3 lo, uvec3 hi, uint meta, uint octant4, float tMax) {
    // Swap near and far planes once for the four children.
    uvec3 nearWord = mix(lo, hi, lessThan(ray.inverse, vec3(0.0)));
    uvec3 farWord = mix(hi, lo, lessThan(ray.inverse, vec3(0.0)));
    vec3 nearOrigin = ray.origin + pad, farOrigin = ray.origin - pad;
    vec4 nearX = (p.x + byteFloats(nearWord.x) * cell.x - nearOrigin.x) * ray.inverse.x;
    vec4 nearY = (p.y + byteFloats(nearWord.y) * cell.y - nearOrigin.y) * ray.inverse.y;
    vec4 nearZ = (p.z + byteFloats(nearWord.z) * cell.z - nearOrigin.z) * ray.inverse.z;
    vec4 farX = (p.x + byteFloats(farWord.x) * cell.x - farOrigin.x) * ray.inverse.x;
    vec4 farY = (p.y + byteFloats(farWord.y) * cell.y - farOrigin.y) * ray.inverse.y;
    vec4 farZ = (p.z + byteFloats(farWord.z) * cell.z - farOrigin.z) * ray.inverse.z;
    vec4 tNear = max(max(nearX, nearY), max(nearZ, vec4(0.0)));
    vec4 tFar = min(min(farX, farY), min(farZ, vec4(tMax))) * kFarSlack;
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
    uint octant4 = ray.octant * 0x01010101u;
    vec3 reach = max(abs(n.origin - ray.origin), abs(n.origin + 255.0 * cell - ray.origin));
    vec3 pad = sign(ray.inverse) * (9.5367432e-7 * max(reach.x, max(reach.y, reach.z)));   // 8 ulps
    return intersectHalf(ray, n.origin, cell, pad, uvec3(n.loX0, n.loY0, n.loZ0), uvec3(n.hiX0, n.hiY0, n.hiZ0), n.meta0,
                         octant4, tMax) |
           intersectHalf(ray, n.origin, cell, pad, uvec3(n.loX1, n.loY1, n.loZ1), uvec3(n.hiX1, n.hiY1, n.hiZ1), n.meta1,
                         octant4, tMax);
}
