// Next event estimation: one light chosen by power, one point on it. [estimator.md, step 5 and Lights]

struct LightSample {
    vec3 target;      // end of the shadow ray; a direction where `infinite`
    bool infinite;
    float distance;   // to the light
    vec3 wi;          // unit, towards the light
    vec3 radiance;    // Le, or irradiance of a delta light; 0: nothing arrives
    float pdf;        // per solid angle, choice of the light included; of a delta light: of the choice alone
    bool delta;
    uint group;       // of the film's layers of light
};

// Radiance a triangle light sends from barycentric (b0, b1): factor x texture.
vec3 triangleLightEmission(LightRecord light, vec2 b01) {
    if (kHasTexturedEmission == 0u) return light.color;
    uint base = scene.triangles + light.index * 4u;
    MaterialRecord m = loadMaterial(sceneWord(base).w >> kTriangleMaterialShift);
    uvec3 vertices = sceneWord(base + 3u).xyz;
    SurfaceUv uv = interpolateUv(vertices, loadVertex(vertices.x), loadVertex(vertices.y), loadVertex(vertices.z),
                                 vec3(b01, 1.0 - b01.x - b01.y));
    return light.color * surfaceTexture(m.emissiveTexture, uv).rgb;
}

// A triangle light as `from` sees it.
SphericalTriangle seenFrom(LightRecord light, vec3 from) {
    return makeSphericalTriangle(from, light.a, light.b, light.c);
}

// Density of its samples per steradian, choice included; 0 from behind it and from within its offset of its plane.
float triangleLightPdf(LightRecord light, SphericalTriangle seen) {
    float height = light.kind == kLightTriangleTwoSided ? abs(seen.height) : seen.height;
    return height > light.offset && seen.solidAngle > 0.0 ? light.pmf / seen.solidAngle : 0.0;
}

LightSample sampleTriangleLight(LightRecord light, vec3 from, vec2 u) {
    LightSample s;
    SphericalTriangle seen = seenFrom(light, from);
    vec2 b = squareToSphericalTriangle(seen, u);
    vec3 point = b.x * light.a + b.y * light.b + (1.0 - b.x - b.y) * light.c;
    vec3 toLight = point - from;
    float d2 = dot(toLight, toLight);
    s.wi = toLight * inversesqrt(d2);
    s.distance = sqrt(d2);
    s.target = point + seen.normal * (seen.height >= 0.0 ? light.offset : -light.offset);
    s.infinite = false;
    s.delta = false;
    s.pdf = triangleLightPdf(light, seen);
    s.radiance = s.pdf > 0.0 ? triangleLightEmission(light, b) : vec3(0.0);
    return s;
}

LightSample samplePunctualLight(LightRecord light, vec3 from) {
    LightSample s;
    s.infinite = light.kind == kLightDirectional;
    vec3 toLight = light.a - from;
    float d2 = dot(toLight, toLight);
    s.wi = s.infinite ? -light.b : toLight * inversesqrt(d2);
    s.distance = s.infinite ? uintBitsToFloat(0x7f800000u) : sqrt(d2);
    s.target = s.infinite ? s.wi : light.a;
    s.radiance = s.infinite ? light.color : (d2 > 0.0 ? punctualIrradiance(light, s.wi, d2) : vec3(0.0));
    s.pdf = light.pmf;
    s.delta = true;
    return s;
}

LightSample sampleEnvironmentLight(float pmf, vec2 u) {
    LightSample s;
    s.wi = sampleEnvironmentDirection(u, s.pdf);
    s.target = s.wi;
    s.infinite = true;
    s.distance = uintBitsToFloat(0x7f800000u);
    s.radiance = environmentLookup(s.wi).rgb;
    s.pdf *= pmf;
    s.delta = false;
    return s;
}

// A light, and what is left of the number that chose it, from 0 to below 1.
struct LightChoice {
    uint light;
    float rest;
};

LightChoice chooseLight(uint bits) {
    float u = toUnit(bits), beyondU = float(bits & 0xffu) * 2.3283064365386963e-10;  // 2^-32
    if (scene.lightCount == 1u) return LightChoice(0u, min(u + beyondU, kBelowOne));
    uvec3 found = searchCdf(scene.lightCdf, scene.lightCount, u, kLightSteps);
    float before = uintBitsToFloat(found.y);
    return LightChoice(found.x, min((u - before + beyondU) / (uintBitsToFloat(found.z) - before), kBelowOne));
}

// `bits`: two sampler values; the first chooses both the light and one coordinate of the point on it.
LightSample sampleLight(vec3 from, uvec2 bits) {
    LightSample s = LightSample(vec3(0.0), false, 0.0, vec3(0.0), vec3(0.0), 0.0, false, 0u);
    if (scene.lightCount == 0u) return s;
    LightChoice choice = chooseLight(bits.x);
    LightRecord light = loadLight(choice.light);
    vec2 u = vec2(choice.rest, toUnit(bits.y));
    if (kHasTriangleLights != 0u && light.kind <= kLightTriangleTwoSided) s = sampleTriangleLight(light, from, u);
    if (kHasPunctualLights != 0u && light.kind >= kLightPoint && light.kind <= kLightDirectional)
        s = samplePunctualLight(light, from);
    if (kHasEnvironment != 0u && light.kind == kLightEnvironment) s = sampleEnvironmentLight(light.pmf, u);
    s.group = kGroupWord != kNone ? sceneNumber(scene.lightGroups, choice.light) : 0u;
    return s;
}
