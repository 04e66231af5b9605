// Triangles projected onto the unit sphere around a point: their solid angle, and points uniform in it. [Arvo 95]

struct SphericalTriangle {
    vec3 a, b, c;      // unit directions of the corners
    vec3 scale;        // 1 over their distances
    vec3 normal;       // unit, from where the corners run counter-clockwise
    float height;      // of the point above the plane, on the side of the normal
    float volume;      // |a . (b x c)|
    float rest;        // 1 + a . b + b . c + c . a, to which the volume is as sine to cosine of half the solid angle
    float solidAngle;  // steradians
};

// Of the corners a, b, c, as seen from a point. Volume and normal are made of the sides as they are, not of differences
// of directions: small and distant triangles keep their digits.
SphericalTriangle makeSphericalTriangle(vec3 from, vec3 a, vec3 b, vec3 c) {
    SphericalTriangle t;
    vec3 n = cross(b - a, c - a);
    a -= from;
    b -= from;
    c -= from;
    t.scale = inversesqrt(max(vec3(dot(a, a), dot(b, b), dot(c, c)), 1e-37));
    t.a = a * t.scale.x;
    t.b = b * t.scale.y;
    t.c = c * t.scale.z;
    t.normal = normalize(n);
    t.height = -dot(t.normal, a);
    t.volume = abs(dot(t.a, n)) * t.scale.y * t.scale.z;
    t.rest = 1.0 + dot(t.a, t.b) + dot(t.b, t.c) + dot(t.c, t.a);
    t.solidAngle = 2.0 * atan2Accurate(t.volume, t.rest);  // [Van Oosterom 83]
    return t;
}

// 1 + cosine of the angle of two unit vectors. It keeps its digits where they are nearly opposite, as two corners are
// from beside an edge.
float onePlusCosine(vec3 u, vec3 v) {
    vec3 sum = u + v;
    return 0.5 * dot(sum, sum);
}

// Barycentrics (b0, b1) of the point that (u0, u1) has: the arc from a to c is cut at x so that (a, b, x) has the share
// u0 of the solid angle, and the arc from b to x where 1 - cosine is the share u1 of that of x. With the half vector
// (q + r) a + q c of a and x, [Van Oosterom 83] is linear in q and r, and neither is below 0. [Peters 21]
vec2 squareToSphericalTriangle(SphericalTriangle t, vec2 u) {
    float turns = t.solidAngle * (0.25 / kPi);  // half the solid angle
    float q = cosSinTurns(turns * u.x).y * onePlusCosine(t.a, t.b);
    float r = cosSinTurns(turns * (1.0 - u.x)).y * length(vec2(t.volume, t.rest));
    float k = onePlusCosine(t.a, t.c);
    vec2 x = vec2(r * (r + 2.0 * q), 2.0 * q * (r + q * k)) / max(r * r + 2.0 * q * (q + r) * k, 1e-37);  // of a and c
    vec3 arcEnd = x.x * t.a + x.y * t.c, beyond = arcEnd - t.b;
    float m = 0.5 * dot(beyond, beyond);  // 1 - cosine of b and x
    float along = sqrt(max(u.y * (2.0 - u.y * m) / max(onePlusCosine(arcEnd, t.b), 1e-14), 0.0));
    vec3 weights = max(vec3(along * x.x, 1.0 - u.y * m - along * (1.0 - m), along * x.y) * t.scale, 0.0);
    return weights.xy / (weights.x + weights.y + weights.z);
}
