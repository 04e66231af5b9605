// Everything a path vertex needs to know of the surface it met. World space. [estimator.md, Shading point]

struct ShadingPoint {
    vec3 position;
    vec3 ng;           // geometric normal on the side of wo
    bool front;
    float offset;      // distance by which new rays leave along ng
    ShadingFrame frame;
    SurfaceUv uv;
    uint materialIndex;
    MaterialRecord material;
    MaterialMaps maps;
    uint light;        // its LightRecord, or kNone
    vec3 tangent;      // across the interpolated normal; 0 where neither a normal map nor the BSDF needs one
};

// Bends ns until the mirror direction leaves the surface. [Keller 17, app. A.3]
vec3 bendNormal(vec3 wo, vec3 ns, vec3 ng) {
    const float least = 0.01;
    vec3 r = reflect(-wo, ns);
    float below = dot(r, ng);
    if (below >= least) return ns;
    return normalize(wo + normalize(r + ng * (least - below)));
}

bool hasNormalMap(MaterialRecord m) {
    return (kSceneMaps & (1u << kMapNormal)) != 0u && m.normalTexture != kNone;
}

// t across n, of length 1, or 0 where nothing is left of it.
vec3 tangentAcross(vec3 t, vec3 n) {
    vec3 across = t - n * dot(n, t);
    float t2 = dot(across, across);
    return t2 > 0.0 ? across * inversesqrt(t2) : vec3(0.0);
}

// Normal map in the frame of the unflipped normal and of the tangent across it, whose handedness is w.
vec3 applyNormalMap(MaterialRecord m, vec4 texel, vec3 n, vec3 t, float w) {
    if (!hasNormalMap(m) || t == vec3(0.0)) return n;
    vec3 c = texel.xyz * 2.0 - 1.0;
    vec3 mapped = c.x * m.normalScale * t + c.y * m.normalScale * w * cross(n, t) + c.z * n;
    float length2 = dot(mapped, mapped);
    return length2 > 0.0 ? mapped * inversesqrt(length2) : n;
}

vec3 maxAbs(vec3 a, vec3 b) { return max(a, abs(b)); }

ShadingPoint makeShadingPoint(uint slot, uint instance, vec2 b12, vec3 wo) {
    TriangleRecord tri = loadTriangle(slot);
    uvec3 vertices = uvec3(tri.i0, tri.i1, tri.i2);
    VertexRecord a = loadVertex(vertices.x), b = loadVertex(vertices.y), c = loadVertex(vertices.z);
    vec3 w = vec3(1.0 - b12.x - b12.y, b12);
    ShadingPoint p;
    vec3 n = w.x * unpackNormal(a.normal) + w.y * unpackNormal(b.normal) + w.z * unpackNormal(c.normal);
    vec4 ta = unpackTangent(a.tangent);
    vec3 t = w.x * ta.xyz + w.y * unpackTangent(b.tangent).xyz + w.z * unpackTangent(c.tangent).xyz;
    vec3 ng = cross(tri.v1 - tri.v0, tri.v2 - tri.v0), magnitude = vec3(0.0);
    if (kHasInstances != 0u) {
        InstanceRecord r = loadInstance(instance);
        mat3 toWorld = transpose(mat3(r.worldFromObject[0].xyz, r.worldFromObject[1].xyz, r.worldFromObject[2].xyz));
        mat3 cofactor = mat3(r.objectFromWorld[0].xyz, r.objectFromWorld[1].xyz, r.objectFromWorld[2].xyz);
        vec3 translation = vec3(r.worldFromObject[0].w, r.worldFromObject[1].w, r.worldFromObject[2].w);
        tri.v0 = toWorld * tri.v0 + translation;
        tri.v1 = toWorld * tri.v1 + translation;
        tri.v2 = toWorld * tri.v2 + translation;
        magnitude = abs(translation);
        n = cofactor * n;
        ng = cofactor * ng;
        t = toWorld * t;
        ta.w *= determinant(toWorld) < 0.0 ? -1.0 : 1.0;
    }
    p.position = w.x * tri.v0 + w.y * tri.v1 + w.z * tri.v2;
    magnitude = maxAbs(maxAbs(maxAbs(magnitude, tri.v0), tri.v1), tri.v2);
    vec3 nGeometric = normalize(ng);  // of the front side
    p.front = dot(nGeometric, wo) >= 0.0;
    float side = p.front ? 1.0 : -1.0;
    p.ng = side * nGeometric;
    p.offset = kOffsetScale * maxComponent(magnitude);
    p.uv = interpolateUv(vertices, a, b, c, w);
    p.materialIndex = tri.flags >> kTriangleMaterialShift;
    p.material = loadMaterial(p.materialIndex);
    p.maps = sampleMaterialMaps(p.material, p.uv);
    p.light = tri.light;
    float n2 = dot(n, n);
    n = n2 > 0.0 ? n * inversesqrt(n2) : nGeometric;
    bool needsTangent = hasNormalMap(p.material) || (p.material.flags & kMaterialTangents) != 0u;
    p.tangent = needsTangent ? tangentAcross(t, n) : vec3(0.0);
    vec3 ns = side * applyNormalMap(p.material, p.maps.normal, n, p.tangent, ta.w);
    p.frame = makeFrame(bendNormal(wo, ns, p.ng));
    return p;
}
