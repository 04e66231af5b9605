// Hits of the device against those of the reference, ray by ray.
#pragma once
#include "reference/hit.h"
#include "verify/findings.h"

namespace vkpt {

/// A hit as kernels write it; slot kNone: a miss. instance is 0 where nothing is instanced.
struct DeviceHit {
    float t = 0;
    std::uint32_t slot = kNone;
    float b1 = 0, b2 = 0;
    std::uint32_t instance = 0;
};

struct HitTolerance {
    double relative = 1e-4;  ///< of t, and tenfold of the barycentrics
    float edge = 1e-4F;      ///< how near an edge, in barycentrics, rounding may decide
    bool worldDepth = true;  ///< corners are in world space
    bool jitter = false;     ///< excuse, too, what the reference meets along rays within rounding of this one
};

struct HitCounts {
    int rays = 0, hits = 0, edges = 0;
};

/// Both name the same triangle of the same instance at the same distance; of triangles at equal distance the same one.
/// A ray that passes an edge may go either way: such are excused and counted. Returns whether all is well.
bool compareHit(const SceneArrays& arrays, const reference::Ray& ray, std::uint32_t alphaKey, const DeviceHit& hit,
                const HitTolerance& tolerance, Findings& findings, HitCounts& counts);

}  // namespace vkpt
