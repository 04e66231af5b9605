// Specialization constants of every kernel: what a render does not need is not in its kernels. Counts bound loops, which
// then unroll: where invocations run in lockstep on a CPU, a loop saves and loads all that is live at each round.
// Changed the order? Update specializationOf (src/wavefront/kernels.cpp).
#include "integrators.glsl"
layout(constant_id = 0) const uint kSampler = 0u;
layout(constant_id = 1) const uint kFetchTexel = 0u;       // read the scene through a texel buffer
layout(constant_id = 2) const uint kHasInstances = 0u;
layout(constant_id = 3) const uint kHasAlpha = 0u;
layout(constant_id = 4) const uint kSceneMaps = 0u;        // roles of the maps that some material has
layout(constant_id = 5) const uint kHasVertexExtras = 0u;
layout(constant_id = 6) const uint kHasTriangleLights = 0u;
layout(constant_id = 7) const uint kHasTexturedEmission = 0u;
layout(constant_id = 8) const uint kHasPunctualLights = 0u;
layout(constant_id = 9) const uint kHasEnvironment = 0u;
layout(constant_id = 10) const uint kHasUnlit = 0u;
layout(constant_id = 11) const uint kUseBallot = 0u;       // compaction by subgroup ballot, else by shared memory
layout(constant_id = 12) const uint kStateTexel = 0u;      // read path state through a texel buffer
layout(constant_id = 13) const uint kHasTransforms = 1u;   // some texture has KHR_texture_transform
layout(constant_id = 14) const uint kMapSets = 4u;         // sets of maps that some material has, at most
layout(constant_id = 15) const uint kIndexDigits = 8u;     // hexadecimal digits that hold every sample index
layout(constant_id = 16) const uint kLightSteps = 32u;     // of searchCdf in each of its tables
layout(constant_id = 17) const uint kRowSteps = 32u;
layout(constant_id = 18) const uint kColumnSteps = 32u;
layout(constant_id = 19) const uint kScramble = kScrambleOwen;
// The film's layers: words a pixel, and where each begins; kNone: absent. See src/film/film_layout.h.
layout(constant_id = 20) const uint kLayerWords = 0u;
layout(constant_id = 21) const uint kAlbedoWord = kNone;
layout(constant_id = 22) const uint kNormalWord = kNone;
layout(constant_id = 23) const uint kDepthWord = kNone;
layout(constant_id = 24) const uint kPositionWord = kNone;
layout(constant_id = 25) const uint kUvWord = kNone;
layout(constant_id = 26) const uint kIdsWord = kNone;
layout(constant_id = 27) const uint kLuminanceWord = kNone;
// N of the render where the sampler's points depend on it; 0: unknown until the kernel runs.
layout(constant_id = 28) const uint kSetSamples = 0u;
// Models (ids of registry.def) and shade groups (kGroup*) that the scene has, a bit each.
layout(constant_id = 29) const uint kBsdfModels = 1u;
layout(constant_id = 30) const uint kShadeGroups = 1u;
layout(constant_id = 31) const uint kMultiscatter = 0u;    // interreflection between facets is compensated
// Selectors of RenderParams.
layout(constant_id = 32) const uint kIntegrator = kIntegratorPath;
layout(constant_id = 33) const uint kStrategy = kStrategyMisPower;
layout(constant_id = 34) const uint kBeta = 2u;            // of the heuristic where it is 1 or 2; 0: RenderParams.beta
layout(constant_id = 35) const uint kHemisphere = kHemisphereBsdf;
layout(constant_id = 36) const uint kProjection = kProjectionPerspective;
layout(constant_id = 37) const uint kHasFilter = 0u;       // the pixel filter has a table
layout(constant_id = 38) const uint kHasLens = 0u;
layout(constant_id = 39) const uint kHasMedia = 0u;        // some dielectric absorbs
layout(constant_id = 40) const uint kHasNegativeLobes = 0u; // the pixel filter may take light away
// The film's layers of light: where each kind begins, kNone: absent; layers by the length of the path.
layout(constant_id = 41) const uint kLengthWord = kNone;
layout(constant_id = 42) const uint kLengthLayers = 1u;
layout(constant_id = 43) const uint kGroupWord = kNone;
layout(constant_id = 44) const uint kListTriangles = 0u;  // that rays are tested against; 0: the tree is walked
layout(constant_id = 45) const uint kStackEntries = kMaxStackEntries;  // that a walk of the tree needs, at most
layout(constant_id = 46) const uint kInlineShadows = 0u;  // shade traces its light samples itself: no shadow stage
const bool kHasSurfaceLayers = kAlbedoWord != kNone || kNormalWord != kNone || kDepthWord != kNone ||
                               kPositionWord != kNone || kUvWord != kNone || kIdsWord != kNone;
