#include "verify/check.h"
#include "verify/images.h"
#include "verify/probes.h"
#include "verify/stages.h"

namespace vkpt {
namespace {

constexpr std::array kChecks = {
    Check{Rung::Layout, "shared structs", "shared/layout.h in both fetch forms: to the bit", checkLayout},
    Check{Rung::Layout, "path state", "kernels/state.glsl: arrays, counters, queues, push constants", checkState},
    Check{Rung::Layout, "specialization", "every specialization constant, by name", checkSpecialization},

    Check{Rung::Integers, "hash", "pcg4d and its floats: to the bit", checkHash},
    Check{Rung::Integers, "samplers", "bits of every sampler of the registry: to the bit", checkSamplers},
    Check{Rung::Integers, "tables", "inversion of tabulated distributions: equal indices", checkCdf},
    Check{Rung::Integers, "exact film", "rounding, sums and refusals against 128-bit integers", checkFixedPoint},
    Check{Rung::Integers, "film layers", "signed values, path luminance and squares: to the bit", checkFilmLayers},
    Check{Rung::Integers, "compaction", "each wanted slot once, without gaps, in every form", checkAppend},

    Check{Rung::Functions, "trigonometry", "within 2e-7 (cos, sin), 3e-7 (atan2), 6e-7 (acos)", checkTrigonometry},
    Check{Rung::Functions, "warps", "square to disk and hemisphere (4e-7)", checkWarp},
    Check{Rung::Functions, "frames", "orthonormal bases within 1e-6", checkFrame},
    Check{Rung::Functions, "octahedral", "packed normals and tangents within 3e-7", checkOctahedral},
    Check{Rung::Functions, "colour and MIS", "sRGB within 1e-6, luminance and power heuristic 1e-6", checkColor},
    Check{Rung::Functions, "ggx", "D, G1, G2, pdf within 1e-5; visible normals", checkGgx},
    Check{Rung::Functions, "special functions", "erf 3e-7, its inverse 4e-6, logarithms and powers 1e-6",
          checkSpecialFunctions},
    Check{Rung::Functions, "fresnel", "dielectrics 1e-6, conductors 2e-6", checkFresnel},
    Check{Rung::Functions, "facets", "every distribution and masking: D, G1, G2, pdf 1e-5; normals 5e-6", checkFacets},
    Check{Rung::Functions, "albedo tables", "lookups within 1e-5", checkAlbedo},
    Check{Rung::Functions, "gltf bsdf", "f, pdf within 3e-5; samples and weights 1e-4", checkGltf},
    Check{Rung::Functions, "bsdf models", "every other model of the registry: f, pdf 5e-5; samples 1e-5, weights 1e-4",
          checkBsdfs},
    Check{Rung::Functions, "textures", "every wrap, filter and transform", checkTexture},
    Check{Rung::Functions, "material maps", "maps read together against each read alone", checkMaps},
    Check{Rung::Functions, "environment", "radiance, densities (equal), sampled directions", checkEnvironment},
    Check{Rung::Functions, "lights", "samples of every kind of light", checkLights},
    Check{Rung::Functions, "shading points", "positions, normals, maps, offsets, texture coordinates",
          checkShadingPoint},
    Check{Rung::Functions, "triangles", "hits against float and double; no gaps at edges", checkTriangle},
    Check{Rung::Functions, "traversal", "closest and any hit, alpha, two levels, ties", checkTraverse},

    Check{Rung::Stages, "generate", "camera rays of the scene", checkGenerate},
    Check{Rung::Stages, "intersect", "hit records of camera and bounce rays; queues", checkIntersect},
    Check{Rung::Stages, "miss", "environment and background, weighted", checkMiss},
    Check{Rung::Stages, "shade", "emission, light samples, next rays, throughput, roulette", checkShade},
    Check{Rung::Stages, "shadow", "which light samples arrive, and their sums", checkShadow},
    Check{Rung::Stages, "accumulate", "the film is the sum of its paths: to the bit", checkAccumulate},
    Check{Rung::Stages, "every feature", "all kernels on a scene in memory that needs all of them", checkEveryFeature},
    Check{Rung::Stages, "every bsdf", "all kernels on a scene in memory of every model, and of all interreflections",
          checkEveryBsdf},

    Check{Rung::SameSeed, "same seed", "0.05 % of paths may part a segment unexcused; the mean stays within its errors",
          checkSameSeed},
    Check{Rung::OtherSeeds, "other seeds", "means of 8x8 tiles and of the image; 1 % false alarms in all",
          checkOtherSeeds},
};

}  // namespace

std::span<const Check> verifyChecks() { return kChecks; }

}  // namespace vkpt
