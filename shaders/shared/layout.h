// Data layouts shared by the host, the CPU reference and the shaders. Compiled as C++ and as GLSL.
// Data only: no function bodies. Every struct is a whole number of 16-byte words ("words" below); the device
// reads scene data word by word through shaders/geometry/fetch.glsl. src/verify reads every field back.
// Changed a struct here? Update its load function in shaders/geometry/load.glsl and the layout probe.
#ifndef VKPT_SHARED_LAYOUT_H
#define VKPT_SHARED_LAYOUT_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace vkpt {
using uint = std::uint32_t;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#endif

// ---- geometry ---------------------------------------------------------------------------------------------

// One triangle, in the order of the BVH's leaves. Positions are world space where the geometry is baked, object
// space where its mesh is instanced. Counter-clockwise seen from the front (a negative scale is already undone).
struct TriangleRecord {
    vec3 v0;
    uint flags;  // kTriangle* bits | material index << kTriangleMaterialShift
    vec3 v1;
    uint light;      // index of its LightRecord, or kNone
    vec3 v2;
    uint primitive;  // unique id of the triangle in the scene, independent of the BVH's order
    uint i0, i1, i2; // indices of VertexRecord (and of VertexExtra)
    uint object;     // index of the mesh instance it was baked from; unused where InstanceRecord.object is not kNone
};

// Shading attributes of a vertex: 16-bit octahedral normal, 15-bit octahedral tangent with its handedness.
struct VertexRecord {
    uint normal;   // packed: see kOct* in constants.h
    float u0, v0;  // TEXCOORD_0
    uint tangent;  // packed: see kOct* in constants.h
};

// Attributes few scenes have. Present for every vertex or for none (SceneHeader.vertexExtras == kNone).
struct VertexExtra {
    float u1, v1;   // TEXCOORD_1
    uint colorRG;   // COLOR_0, linear, unorm16: red in the low half
    uint colorBA;   // blue in the low half
};

// Node of the compressed 8-wide BVH: child boxes quantised to 8 bits on a grid of powers of two. [Ylitie 17]
// Child s is an inner node, a leaf of 1 to 3 items, or empty (meta byte 0). See src/bvh/wide_node.h.
struct WideNode {
    vec3 origin;        // grid origin p
    uint exponents;     // bytes: biased exponent of x, y, z; inner-node mask (bit s: child s is a node)
    uint childBase;     // index of the first inner child
    uint itemBase;      // index of the first leaf item: a triangle, or an instance in the top level
    uint meta0, meta1;  // a byte a child
    uint loX0, loX1, loY0, loY1, loZ0, loZ1;  // a byte a child: lower corner in grid units, rounded down
    uint hiX0, hiX1, hiY0, hiY1, hiZ0, hiZ1;  // a byte a child: upper corner in grid units, rounded up
};

// One placed mesh of the top level.
struct InstanceRecord {
    vec4 objectFromWorld[3];  // rows
    vec4 worldFromObject[3];  // rows
    uint rootNode;            // index of the WideNode at the root of its mesh
    uint object;              // index of the mesh instance; kNone: each triangle has its own
    uint pad0, pad1;
};

// ---- materials --------------------------------------------------------------------------------------------

// glTF metallic-roughness. Texture fields index TextureRecord, or are kNone. The roles of the maps are numbered in the
// order of the fields: bit r of a set of roles stands for field r.
struct MaterialRecord {
    vec4 baseColor;           // linear
    vec3 emissive;            // nits, emissiveStrength applied
    float metallic;
    float roughness;          // perceptual; alpha = roughness^2
    float normalScale;
    float alphaCutoff;
    uint flags;               // kMaterial* bits; from kMaterialMapSetShift on the sets of maps, see constants.h
    uint baseColorTexture, metallicRoughnessTexture, normalTexture, emissiveTexture;
};

// Parameters of the other BSDF models; one a material where any material has such a model, else none at all. Which
// fields a model reads: estimator.md, BSDF models.
struct BsdfRecord {
    vec3 color;       // linear reflectance, tint or specular colour
    float alphaX;     // roughness, never squared; along the tangent
    vec3 diffuse;     // linear reflectance of the diffuse part; dielectric: absorption behind it, 1/m
    float alphaY;     // along the bitangent
    vec3 eta;         // index of refraction; of conductors its real part, a channel each
    float exponentX;
    vec3 k;           // imaginary part
    float exponentY;
    vec3 average;     // x: hemispherical mean of a dielectric's Fresnel term, from outside; y from inside
    float weight;     // cook_torrance: of the distribution with alphaX, the rest has alphaY
    uint flags;       // kBsdf* bits
    uint table;       // first word of its albedo table in the section of tables; kNone: none
    float sigma;      // oren_nayar: standard deviation of facet angles in radians; eon: roughness
    float specular;   // cook_torrance: share of the specular part, s
};

// One cell of an albedo table: roots of (second, 1 - first - second) as unorm16, the former in the low half, at its
// four corners.
// Averages are floats (their bits) at two corners, j and j + 1: (1 - first - second)/alpha^2 in x and y, second in z and
// w. Walks, one a row (estimator.md, Interreflection): of conductors unorm16 (c0, c1) in x and (e0, e1) in y, of
// dielectrics the floats rho in x and b in y; the float m in z.
struct AlbedoCell {
    uint x, y, z, w;  // (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1): cell j (kAlbedoSide - 1) + i, j the row
};

// One use of an image by a material: sampler and KHR_texture_transform included.
struct TextureRecord {
    uint texels;      // index of the first texel in the texel array (RGBA8, R in the low byte, 4 a word)
    uint size;        // width | height << 16
    uint flags;       // kTexture* bits
    uint stride;      // 1, 2 or 4: from one texel to the next in the texel array; images of a set are interleaved
    vec4 rowU;        // u' = dot(rowU.xyz, (u, v, 1))
    vec4 rowV;        // v' = dot(rowV.xyz, (u, v, 1))
};

// ---- lights -----------------------------------------------------------------------------------------------

// One light. `kind` is a kLight* constant. pmf: the probability of being chosen.
//   triangle:    a, b, c are its corners (world space), color its emissive factor in nits, index its triangle
//   point, spot: a position, b direction of the beam, c = (angle scale, angle offset, range or 0), color candela
//   directional: b the direction in which light travels, color lux
//   environment: nothing else; see EnvironmentHeader
struct LightRecord {
    vec3 a;
    uint kind;
    vec3 b;
    float pmf;
    vec3 c;
    float offset;  // triangle: metres off its plane at which shadow rays end
    vec3 color;
    uint index;    // triangle: slot in the triangle array
};

// ---- headers: the uniform buffer -------------------------------------------------------------------------

// Where each section of the scene buffer starts, in words; kNone where it is absent.
struct SceneHeader {
    uint nodes, triangles, vertices, vertexExtras;
    uint instances, materials, textures, texels;
    uint lights, lightCdf, lightCount, rootNode;
    uint envTexels;   // vec4 a texel: radiance in nits, pdf per solid angle of the texel's cell
    uint envRows;     // marginal CDF over rows: envHeight floats, 4 a word
    uint envColumns;  // conditional CDFs: a row after the other, each padded to whole words
    uint envLight;    // index of the environment in the light array, or kNone
    uint envWidth, envHeight;
    float envCos, envSin;  // rotation about +y
    uint samplerTable;     // of the sampler in use: see shaders/samplers/
    uint bsdfs;            // BsdfRecord a material
    uint albedoTables;     // kAlbedoTableWords a table; the first is glTF's
    uint filterTable;      // FilterCell an interval, kFilterSteps; kNone: the box of one pixel
    uint lightGroups;      // the group of each light, 4 a word
    uint objectGroups;     // the group of each mesh instance, 4 a word
    uint groupBehind;      // of environment and background
    uint headerPad;
};

// An interval of one axis of a pixel filter: all intervals are drawn alike.
struct FilterCell {
    float begin, end;  // pixels from the middle of the pixel
    float weight;      // of what is drawn from it; below 0 where the filter is
    float pad;
};

// What one render does; the same for all its batches.
struct RenderParams {
    vec3 eye;            // centre of projection; orthographic: centre of the window
    uint projection;     // kProjection*
    vec3 right;          // from the middle to the right edge of the window, at distance 1 (or in metres); panorama: unit
    uint width;          // of the full frame
    vec3 up;             // from the middle to the upper edge; panorama: unit
    uint height;
    vec3 forward;        // unit
    uint seed;
    vec3 background;     // what camera rays see where nothing is, if backgroundMode is kBackgroundColor
    uint backgroundMode; // kBackground*
    uint spp;            // N of the whole render: samplers that need a fixed count know it
    uint maxDepth;       // 0: emission only, 1: direct light too
    uint rrMode;         // kRoulette*
    uint rrDepth;        // Russian roulette begins after this many scatterings
    float rrFixed;       // survival probability of kRouletteFixed
    float lensRadius;    // metres; 0: a pinhole
    float focusDistance; // metres along `forward`, where what a lens sees is sharp
    float clampIndirect; // nits that a contribution of two and more scatterings may have; 0: no limit
    uint integrator;     // an id of registry.def
    uint strategy;       // kStrategy*
    uint hemisphere;     // kHemisphere*
    float beta;          // exponent of the heuristic that weights light and BSDF samples; kStrategyMisPower only
    uint bsdfSamples, lightSamples;  // of integrator direct, at the first surface
    float aoDistance;    // metres within which integrator ao looks for surfaces; infinite: everywhere
    uint pixelFilter;    // kFilter*
    float filterRadius;  // pixels
    uint paramsPad0, paramsPad1, paramsPad2;
};

// Exact sums of one path or one pixel: a channel is 96 bits, little-endian words, kFilmFractionBits of fraction.
// w: counts of paths; red: alpha (met a surface or a visible background), green: met a surface, blue: unused.
struct FilmSums {
    uvec4 red, green, blue;
};

#ifdef __cplusplus
static_assert(sizeof(TriangleRecord) == 64 && sizeof(VertexRecord) == 16 && sizeof(VertexExtra) == 16);
static_assert(sizeof(WideNode) == 80 && sizeof(InstanceRecord) == 112);
static_assert(sizeof(MaterialRecord) == 64 && sizeof(TextureRecord) == 48 && sizeof(LightRecord) == 64);
static_assert(sizeof(FilterCell) == 16 && sizeof(BsdfRecord) == 96 && sizeof(AlbedoCell) == 16);
static_assert(sizeof(SceneHeader) == 112 && sizeof(RenderParams) == 160 && sizeof(FilmSums) == 48);
}  // namespace vkpt
#endif
#endif
