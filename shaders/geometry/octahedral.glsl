// Unit vectors packed on the octahedron. [Cigolle 14]
vec3 octahedralToUnit(vec2 e) {
    vec3 v = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (v.z < 0.0) v.xy = (1.0 - abs(v.yx)) * vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0);
    return normalize(v);
}

vec3 unpackNormal(uint bits) {
    return octahedralToUnit(vec2(int(bits << 16u) >> 16, int(bits) >> 16) / kOctNormalMax);
}

// xyz tangent, w handedness.
vec4 unpackTangent(uint bits) {
    vec2 e = vec2(int(bits << 17u) >> 17, int(bits << 2u) >> 17) / kOctTangentMax;
    return vec4(octahedralToUnit(e), (bits >> 31u) != 0u ? -1.0 : 1.0);
}
