// Equirectangular environment: bilinear lookup, and sampling by luminance x sin(theta) through the marginal and
// conditional distributions of its cells. [Pharr 16, §13.6.7 and §14.2.4]

vec3 rotateY(vec3 d, float c, float s) { return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z); }

// (u, v) in [0,1] of a world direction.
vec2 environmentUv(vec3 d) {
    vec3 r = rotateY(d, scene.envCos, scene.envSin);
    return vec2(atan2Accurate(r.z, r.x) * (0.5 * kInvPi) + 0.5, acosAccurate(clamp(r.y, -1.0, 1.0)) * kInvPi);
}

vec4 environmentTexel(int x, int y) {
    int w = int(scene.envWidth), h = int(scene.envHeight);
    x = x < 0 ? x + w : (x >= w ? x - w : x);
    return sceneWordFloat(scene.envTexels + uint(clamp(y, 0, h - 1) * w + x));
}

// Radiance, and in w the pdf per solid angle.
vec4 environmentLookup(vec3 d) {
    vec2 p = environmentUv(d) * vec2(scene.envWidth, scene.envHeight);
    ivec2 cell = ivec2(p);
    vec2 corner = floor(p - 0.5), w = p - 0.5 - corner;
    ivec2 i = ivec2(corner);
    vec4 t00 = environmentTexel(i.x, i.y), t10 = environmentTexel(i.x + 1, i.y);
    vec4 t01 = environmentTexel(i.x, i.y + 1), t11 = environmentTexel(i.x + 1, i.y + 1);
    vec3 radiance = mix(mix(t00.rgb, t10.rgb, w.x), mix(t01.rgb, t11.rgb, w.x), w.y);
    // The pdf belongs to the cell itself, one of the four.
    bool right = min(cell.x, int(scene.envWidth) - 1) != i.x, lower = min(cell.y, int(scene.envHeight) - 1) != i.y;
    float pdf = lower ? (right ? t11.w : t01.w) : (right ? t10.w : t00.w);
    return vec4(radiance, pdf);
}

// World direction; radiance and pdf follow from environmentLookup at that direction's cell.
vec3 sampleEnvironmentDirection(vec2 u, out float pdf) {
    uvec3 row = searchCdf(scene.envRows, scene.envHeight, u.y, kRowSteps);
    float r0 = uintBitsToFloat(row.y), r1 = uintBitsToFloat(row.z);
    uint stride = (scene.envWidth + 3u) >> 2u;
    uvec3 column = searchCdf(scene.envColumns + row.x * stride, scene.envWidth, u.x, kColumnSteps);
    float c0 = uintBitsToFloat(column.y), c1 = uintBitsToFloat(column.z);
    float fy = r1 > r0 ? (u.y - r0) / (r1 - r0) : 0.5, fx = c1 > c0 ? (u.x - c0) / (c1 - c0) : 0.5;
    float height = float(scene.envHeight);
    float top = cosSinTurns(0.5 * float(row.x) / height).x, bottom = cosSinTurns(0.5 * float(row.x + 1u) / height).x;
    float cosTheta = mix(top, bottom, fy), sinTheta = sqrt(max((1.0 - cosTheta) * (1.0 + cosTheta), 0.0));
    vec2 phi = cosSinTurns((float(column.x) + fx) / float(scene.envWidth) - 0.5);
    pdf = sceneWordFloat(scene.envTexels + row.x * scene.envWidth + column.x).w;
    return rotateY(vec3(sinTheta * phi.x, cosTheta, sinTheta * phi.y), scene.envCos, -scene.envSin);
}
