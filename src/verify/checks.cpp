#include "verify/check.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

constexpr std::array kChecks = {
    Check{Rung::Layout, "shared structs", "shared/layout.h in both fetch forms: to the bit", checkLayout},
    Check{Rung::Layout, "path state", "kernels/state.glsl: arrays, counters, queues, push constants", checkState},

    Check{Rung::Integers, "hash", "pcg4d and its floats: to the bit", checkHash},
    Check{Rung::Integers, "samplers", "bits of every sampler of the registry: to the bit", checkSamplers},
    Check{Rung::Integers, "tables", "inversion of tabulated distributions: equal indices", checkCdf},
    Check{Rung::Integers, "exact film", "rounding, sums and refusals against 128-bit integers", checkFixedPoint},
    Check{Rung::Integers, "compaction", "each wanted slot once, without gaps, in every form", checkAppend},

    Check{Rung::Functions, "trigonometry", "within 2e-7 (cos, sin), 3e-7 (atan2), 6e-7 (acos)", checkTrigonometry},
    Check{Rung::Functions, "warps", "square to disk, hemisphere (4e-7) and triangle (equal)", checkWarp},
    Check{Rung::Functions, "frames", "orthonormal bases within 1e-6", checkFrame},
    Check{Rung::Functions, "octahedral", "packed normals and tangents within 3e-7", checkOctahedral},
    Check{Rung::Functions, "colour and MIS", "sRGB within 1e-6, luminance and power heuristic 1e-6", checkColor},
    Check{Rung::Functions, "ggx", "D, G1, G2, pdf within 1e-5; visible normals", checkGgx},
    Check{Rung::Functions, "gltf bsdf", "f, pdf within 3e-5; samples and weights 1e-4", checkGltf},
    Check{Rung::Functions, "textures", "every wrap, filter and transform", checkTexture},
    Check{Rung::Functions, "material maps", "maps read together against each read alone", checkMaps},
    Check{Rung::Functions, "environment", "radiance, densities (equal), sampled directions", checkEnvironment},
    Check{Rung::Functions, "lights", "samples of every kind of light", checkLights},
    Check{Rung::Functions, "shading points", "positions, normals, maps, offsets, texture coordinates",
          checkShadingPoint},
    Check{Rung::Functions, "triangles", "hits against float and double; no gaps at edges", checkTriangle},
    Check{Rung::Functions, "traversal", "closest and any hit, alpha, two levels, ties", checkTraverse},
};

}  // namespace

std::span<const Check> verifyChecks() { return kChecks; }

}  // namespace vkpt
