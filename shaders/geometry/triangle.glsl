// Watertight ray-triangle intersection: edges shared by two triangles leave no gap. [Woop 13]
// Edge tests include zero, so that an edge belongs to both sides; no contraction, so that both see the same value.

struct ShearedRay {
    vec3 origin;
    uvec3 axis;   // permutation; axis.z is the largest component of the direction
    vec3 shear;   // (dx/dz, dy/dz, 1/dz) after the permutation
};

ShearedRay shearRay(vec3 origin, vec3 d) {
    vec3 a = abs(d);
    uint kz = a.x > a.y ? (a.x > a.z ? 0u : 2u) : (a.y > a.z ? 1u : 2u);
    uint kx = kz == 2u ? 0u : kz + 1u, ky = kx == 2u ? 0u : kx + 1u;
    bool flip = d[kz] < 0.0;
    uvec3 k = uvec3(flip ? ky : kx, flip ? kx : ky, kz);
    return ShearedRay(origin, k, vec3(d[k.x], d[k.y], 1.0) / d[kz]);
}

vec3 permute(vec3 v, uvec3 k) {
    return vec3(k.x == 0u ? v.x : (k.x == 1u ? v.y : v.z), k.y == 0u ? v.x : (k.y == 1u ? v.y : v.z),
                k.z == 0u ? v.x : (k.z == 1u ? v.y : v.z));
}

// (t, b0, b1, facing): facing is 1 from the front, -1 from behind, 0 for a miss. b2 = 1 - b0 - b1.
vec4 intersectTriangle(ShearedRay ray, vec3 v0, vec3 v1, vec3 v2) {
    vec3 a = permute(v0 - ray.origin, ray.axis), b = permute(v1 - ray.origin, ray.axis),
         c = permute(v2 - ray.origin, ray.axis);
    precise vec2 pa = a.xy - ray.shear.xy * a.z;
    precise vec2 pb = b.xy - ray.shear.xy * b.z;
    precise vec2 pc = c.xy - ray.shear.xy * c.z;
    precise float u = pc.x * pb.y - pc.y * pb.x;
    precise float v = pa.x * pc.y - pa.y * pc.x;
    precise float w = pb.x * pa.y - pb.y * pa.x;
    bool inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    float det = u + v + w;
    if (!inside || det == 0.0) return vec4(0.0);
    float inverse = 1.0 / det;
    float t = (u * (ray.shear.z * a.z) + v * (ray.shear.z * b.z) + w * (ray.shear.z * c.z)) * inverse;
    return vec4(t, u * inverse, v * inverse, det > 0.0 ? 1.0 : -1.0);
}
