// Triangles projected onto the unit sphere around a point: their solid angle, and points uniform in it. [Arvo 95]

struct SphericalTriangle {
    vec3 a, b, c;      // unit directions of the corners
    vec3 scale;        // 1 over their distances
    vec3 normal;       // unit, from where the corners run counter-clockwise
    float height;      // of the point above the plane, on the side of the normal
    float volume;      // |a . (b x c)|
    float solidAngle;  // steradians
};

// As seen from the origin. The volume is made of the corners themselves, without a difference of large numbers: small
// and distant triangles keep their digits.
SphericalTriangle makeSphericalTriangle(vec3 a, vec3 b, vec3 c) {
    SphericalTriangle t;
    t.scale = inversesqrt(max(vec3(dot(a, a), dot(b, b), dot(c, c)), 1e-37));
    t.a = a * t.scale.x;
    t.b = b * t.scale.y;
    t.c = c * t.scale.z;
    vec3 n = cross(b - a, c - a);
    t.normal = normalize(n);
    t.height = -dot(t.normal, a);
    t.volume = abs(dot(t.a, n)) * t.scale.y * t.scale.z;
    // [Van Oosterom 83]
    t.solidAngle = 2.0 * atan2Accurate(t.volume, 1.0 + dot(t.a, t.b) + dot(t.b, t.c) + dot(t.c, t.a));
    return t;
}

// Barycentrics (b0, b1) of the point that (u0, u1) has: the arc from a to c is cut at x so that (a, b, x) has the share
// u0 of the solid angle, and the arc from b to x where 1 - cosine is the share u1 of that of x. With the half vector h
// of a and x as p a + q c, [Van Oosterom 83] is linear in p and q. [Peters 21]
vec2 squareToSphericalTriangle(SphericalTriangle t, vec2 u) {
    float ab = dot(t.a, t.b), bc = dot(t.b, t.c), ca = dot(t.c, t.a);
    vec2 part = cosSinTurns(t.solidAngle * u.x * (0.25 / kPi));
    float p = part.x * t.volume - part.y * (bc + ca), q = part.y * (1.0 + ab);
    float length2 = p * p + q * q + 2.0 * p * q * ca;
    vec2 x = vec2((p - q) * (p + q), 2.0 * q * (p + q * ca)) / max(length2, 1e-37);  // of a and c
    vec3 beyond = x.x * t.a + x.y * t.c - t.b;
    float m = 0.5 * dot(beyond, beyond);  // 1 - cosine of b and x
    float along = sqrt(max(u.y * (2.0 - u.y * m) / max(2.0 - m, 1e-7), 0.0));
    vec3 weights = max(vec3(along * x.x, 1.0 - u.y * m - along * (1.0 - m), along * x.y) * t.scale, 0.0);
    return weights.xy / (weights.x + weights.y + weights.z);
}
