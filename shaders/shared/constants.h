// Ids, flags and numeric constants shared by host and shaders. Compiled as C++ and as GLSL.
#ifndef VKPT_SHARED_CONSTANTS_H
#define VKPT_SHARED_CONSTANTS_H

#ifdef __cplusplus
#include <cstdint>
#define VKPT_CONST inline constexpr
namespace vkpt {
using uint = std::uint32_t;
#else
#define VKPT_CONST const
#endif

VKPT_CONST uint kNone = 0xffffffffu;

// TriangleRecord.flags
VKPT_CONST uint kTriangleSingleSided = 1u;    // absent when met from behind
VKPT_CONST uint kTriangleHasAlpha = 2u;       // MASK or BLEND: the hit must be confirmed
VKPT_CONST uint kTriangleGroupShift = 4u;     // the shade group of its material: a kGroup* constant, 2 bits
VKPT_CONST uint kTriangleGroupMask = 3u;
VKPT_CONST uint kTriangleMaterialShift = 8u;  // material index above
VKPT_CONST uint kListMax = 64u;               // triangles of the longest list that kernels search whole
VKPT_CONST uint kMaxStackEntries = 31u;       // of a walk of the tree: buildBvh keeps to it

// MaterialRecord.flags
VKPT_CONST uint kMaterialAlphaMask = 1u;   // alphaMode MASK
VKPT_CONST uint kMaterialAlphaBlend = 2u;  // alphaMode BLEND
VKPT_CONST uint kMaterialDoubleSided = 4u;
VKPT_CONST uint kMaterialUnlit = 8u;
VKPT_CONST uint kMaterialVertexColor = 16u; // COLOR_0 multiplies the base colour
VKPT_CONST uint kMaterialTangents = 32u;    // anisotropic: x of the BSDF's frame lies along the vertices' tangents
VKPT_CONST uint kMaterialModelShift = 8u;   // BSDF model: an id of registry.def, 8 bits
VKPT_CONST uint kMaterialModelMask = 255u;
// The maps of a material in up to four sets of roles, 4 bits each, 0 after the last. Maps of one set differ in nothing
// but image and sRGB: they are read at the same texels, whose words lie side by side in the order of their roles,
// within one 16-byte word. Each map that a material has is in one set.
VKPT_CONST uint kMaterialMapSetShift = 16u;
VKPT_CONST uint kMapRoles = 4u;
VKPT_CONST uint kMapBaseColor = 0u;
VKPT_CONST uint kMapMetallicRoughness = 1u;
VKPT_CONST uint kMapNormal = 2u;
VKPT_CONST uint kMapEmissive = 3u;

// Shade groups: BSDF models that share a kernel. Which model is in which, registry.def says.
VKPT_CONST uint kGroupGltf = 0u;
VKPT_CONST uint kGroupMicrofacet = 1u;
VKPT_CONST uint kGroupClassic = 2u;
VKPT_CONST uint kGroups = 3u;

// BsdfRecord.flags
VKPT_CONST uint kBsdfDistributionMask = 3u;  // kDistribution*
VKPT_CONST uint kBsdfMaskingShift = 2u;      // kMasking*
VKPT_CONST uint kBsdfMaskingMask = 3u;
VKPT_CONST uint kBsdfMetal = 16u;            // Fresnel term of a conductor (eta, k), else of a dielectric (eta.x)
VKPT_CONST uint kBsdfConserving = 32u;       // blinn_phong: normalization that conserves energy
VKPT_CONST uint kBsdfAzimuthTable = 64u;     // rows of its albedo table stand for azimuths, else for alphas
VKPT_CONST uint kDistributionGgx = 0u;
VKPT_CONST uint kDistributionBeckmann = 1u;
VKPT_CONST uint kDistributionPhong = 2u;
VKPT_CONST uint kMaskingCorrelated = 0u;     // Smith, height-correlated
VKPT_CONST uint kMaskingSeparable = 1u;      // Smith, separable
VKPT_CONST uint kMaskingVGroove = 2u;
VKPT_CONST uint kAlbedoSide = 48u;           // rows and columns of an albedo table
VKPT_CONST uint kAlbedoTableWords = 2304u;   // (kAlbedoSide - 1)^2 cells, kAlbedoSide - 1 averages, kAlbedoSide walks

// TextureRecord.flags. Wrap fields hold kWrap*.
VKPT_CONST uint kTextureSrgb = 1u;     // decode R, G and B before filtering
VKPT_CONST uint kTextureNearest = 2u;
VKPT_CONST uint kTextureUv1 = 4u;      // read TEXCOORD_1
VKPT_CONST uint kTextureWrapSShift = 4u;
VKPT_CONST uint kTextureWrapTShift = 6u;
VKPT_CONST uint kTextureWrapMask = 3u;
VKPT_CONST uint kWrapRepeat = 0u;
VKPT_CONST uint kWrapClamp = 1u;
VKPT_CONST uint kWrapMirror = 2u;

// Octahedral packing [Cigolle 14]: x in the low half, y in the high half, two's complement snorm (q / max).
// Normals: 16 bits each, max 32767. Tangents: 15 bits x (bits 0-14), 15 bits y (bits 15-29), max 16383;
// bit 31 is set where the handedness w is -1.
VKPT_CONST float kOctNormalMax = 32767.0f;
VKPT_CONST float kOctTangentMax = 16383.0f;

// LightRecord.kind
VKPT_CONST uint kLightTriangle = 0u;
VKPT_CONST uint kLightTriangleTwoSided = 1u;
VKPT_CONST uint kLightPoint = 2u;
VKPT_CONST uint kLightSpot = 3u;
VKPT_CONST uint kLightDirectional = 4u;
VKPT_CONST uint kLightEnvironment = 5u;

// RenderParams
VKPT_CONST uint kProjectionPerspective = 0u;
VKPT_CONST uint kProjectionOrthographic = 1u;
VKPT_CONST uint kProjectionPanorama = 2u;  // equirectangular, the whole sphere
VKPT_CONST uint kBackgroundEnvironment = 0u;
VKPT_CONST uint kBackgroundTransparent = 1u;
VKPT_CONST uint kBackgroundColor = 2u;
VKPT_CONST uint kRouletteOff = 0u;
VKPT_CONST uint kRouletteThroughput = 1u;
VKPT_CONST uint kRouletteFixed = 2u;
// Which estimator of a light's radiance counts. [estimator.md, Strategies]
VKPT_CONST uint kStrategyMisPower = 0u;
VKPT_CONST uint kStrategyMisBalance = 1u;
VKPT_CONST uint kStrategyBsdf = 2u;   // lights are met by chance
VKPT_CONST uint kStrategyLight = 3u;  // next event estimation alone
// How directions are drawn from BSDFs that reflect only and have no delta lobe.
VKPT_CONST uint kHemisphereBsdf = 0u;
VKPT_CONST uint kHemisphereUniform = 1u;
VKPT_CONST uint kHemisphereCosine = 2u;
// Pixel filters. kFilterBox has one pixel's width and no table; see src/scene/pixel_filter.h.
VKPT_CONST uint kFilterBox = 0u;
VKPT_CONST uint kFilterTent = 1u;
VKPT_CONST uint kFilterGaussian = 2u;
VKPT_CONST uint kFilterBlackmanHarris = 3u;
VKPT_CONST uint kFilterMitchell = 4u;
VKPT_CONST uint kFilterSteps = 256u;  // intervals of a filter's table

// Rays: part of the key of the stochastic alpha test.
VKPT_CONST uint kRayPath = 0u;
VKPT_CONST uint kRayShadow = 1u;

// Salts that keep the uses of the hash apart.
VKPT_CONST uint kSaltAlpha = 0xa1fau;
VKPT_CONST uint kSaltSampler = 0x0e11u;

// Scrambles: which of them a sampler has, registry.def says.
VKPT_CONST uint kScrambleNone = 0u;
VKPT_CONST uint kScrambleXor = 1u;    // a random digital shift
VKPT_CONST uint kScrambleDigit = 2u;  // a random permutation for each place of the digits
VKPT_CONST uint kScrambleFaure = 3u;  // one fixed permutation a base
VKPT_CONST uint kScrambleOwen = 4u;   // nested uniform: a random permutation for each node of the tree of digits

// Sizes of samplers.
VKPT_CONST uint kSobolDimensions = 3667u;
VKPT_CONST uint kHaltonDimensions = 256u;
VKPT_CONST uint kRank1Dimensions = 250u;
VKPT_CONST uint kPmj02Tables = 32u;
VKPT_CONST uint kPmj02Points = 4096u;       // of a table
VKPT_CONST uint kZCurveLevels = 8u;         // a Z curve covers 2^8 x 2^8 pixels
VKPT_CONST uint kMaskSide = 128u;           // of the blue-noise mask
VKPT_CONST uint kLargestSet = 65536u;       // samples of a stratified set; more begin another set
VKPT_CONST uint kLargestPrimeSet = 63001u;  // 251^2: the same for orthogonal arrays

VKPT_CONST uint kFilmFractionBits = 48u;
VKPT_CONST uint kFilmLimitBits = 40u;     // contributions are below 2^this
VKPT_CONST uint kLayerLimitBits = 31u;    // values of layers: magnitudes below 2^this
// Path luminance of the variance layer. [estimator.md, Layers]
VKPT_CONST uint kLuminanceFractionBits = 24u;
VKPT_CONST uint kLuminanceLimitBits = 32u;  // channels of the paths it counts are below 2^this
VKPT_CONST uint kLuminanceRed = 13933u;     // weights, times 2^16; together 2^16
VKPT_CONST uint kLuminanceGreen = 46871u;
VKPT_CONST uint kLuminanceBlue = 4732u;
VKPT_CONST uint kWideNodeLeafItems = 3u;   // a leaf holds 1 to 3 items

VKPT_CONST float kBelowOne = 0.999999940395355224609375f;  // 1 - 2^-24
VKPT_CONST float kPi = 3.14159265358979323846f;
VKPT_CONST float kInvPi = 0.31830988618379067154f;
VKPT_CONST float kDeltaAlpha = 1e-4f;      // a microfacet lobe below this alpha is a delta lobe
VKPT_CONST float kDielectricF0 = 0.04f;    // glTF's default index of refraction, 1.5
VKPT_CONST float kOffsetScale = 1.9073486e-6f;  // ray origins leave a surface by this x the magnitude: 2^-19

#ifdef __cplusplus
}  // namespace vkpt
#endif
#endif
