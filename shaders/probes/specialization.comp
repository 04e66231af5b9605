#version 460
// In: nothing that counts. Out: every specialization constant, four a word. src/verify/probes/specialization.cpp lists
// the same.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 12u;
#include "probes/probe.glsl"

void main() {
    if (isIdle()) return;
    putWord(0u, uvec4(kSampler, kFetchTexel, kHasInstances, kHasAlpha));
    putWord(1u, uvec4(kSceneMaps, kHasVertexExtras, kHasTriangleLights, kHasTexturedEmission));
    putWord(2u, uvec4(kHasPunctualLights, kHasEnvironment, kHasUnlit, kUseBallot));
    putWord(3u, uvec4(kStateTexel, kHasTransforms, kMapSets, kIndexDigits));
    putWord(4u, uvec4(kLightSteps, kRowSteps, kColumnSteps, kScramble));
    putWord(5u, uvec4(kLayerWords, kAlbedoWord, kNormalWord, kDepthWord));
    putWord(6u, uvec4(kPositionWord, kUvWord, kIdsWord, kLuminanceWord));
    putWord(7u, uvec4(kSetSamples, kBsdfModels, kShadeGroups, kMultiscatter));
    putWord(8u, uvec4(kIntegrator, kStrategy, kBeta, kHemisphere));
    putWord(9u, uvec4(kProjection, kHasFilter, kHasLens, kHasMedia));
    putWord(10u, uvec4(kHasNegativeLobes, kLengthWord, kLengthLayers, kGroupWord));
    putWord(11u, uvec4(kListTriangles, kStackEntries, kInlineShadows, 0u));
}
