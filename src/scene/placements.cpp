#include "scene/placements.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/error.h"
#include "base/memory.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kBaked = 0;
constexpr glm::mat4 kMirror{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

struct MeshUse {
    std::array<std::uint64_t, 2> places{};  // by handedness: [1] mirrored
    std::array<std::uint32_t, 2> range{kBaked, kBaked};
};

double handedness(const glm::mat4& m) { return glm::determinant(glm::dmat3(glm::dmat4(m))); }

std::uint64_t triangleCount(const Mesh& mesh) {
    std::uint64_t count = 0;
    for (const Primitive& primitive : mesh.primitives) count += primitive.triangles.size();
    return count;
}

bool isEmissive(const Mesh& mesh, const std::vector<MaterialTraits>& traits) {
    for (const Primitive& primitive : mesh.primitives) {
        if (traits[primitive.material].emissive) return true;
    }
    return false;
}

bool worthSharing(const Mesh& mesh, std::uint64_t places, const FlattenOptions& options,
                  const std::vector<MaterialTraits>& traits) {
    return options.instancing && places > 1 && triangleCount(mesh) * (places - 1) >= options.instancingThreshold &&
           !isEmissive(mesh, traits);
}

void addJobs(GeometryPlan& plan, const Mesh& mesh, const glm::mat4& matrix, std::uint32_t object, std::uint32_t range) {
    for (const Primitive& primitive : mesh.primitives) {
        plan.jobs.push_back({&primitive, matrix, object, range, static_cast<std::uint32_t>(plan.vertices)});
        plan.vertices += primitive.positions.size();
    }
}

/// What writing a mesh once takes.
struct Size {
    std::uint64_t primitives = 0, vertices = 0, triangles = 0;

    void operator+=(const Size& other) {
        primitives += other.primitives;
        vertices += other.vertices;
        triangles += other.triangles;
    }
    [[nodiscard]] std::uint64_t bytes() const {
        return primitives * sizeof(GeometryJob) +
               vertices * (sizeof(VertexRecord) + sizeof(VertexExtra) + sizeof(glm::vec3)) +
               triangles * sizeof(TriangleRecord);
    }
};

Size sizeOf(const Mesh& mesh) {
    Size size{mesh.primitives.size(), 0, triangleCount(mesh)};
    for (const Primitive& primitive : mesh.primitives) size.vertices += primitive.positions.size();
    return size;
}

/// A mesh placed again and again makes much of a small file: says so before memory runs out.
void checkSize(const Scene& scene, const std::vector<MeshUse>& uses) {
    std::vector<Size> sizes;
    for (const Mesh& mesh : scene.meshes) sizes.push_back(sizeOf(mesh));
    Size all;
    for (const MeshInstance& instance : scene.instances)
        if (uses[instance.mesh].range[handedness(instance.worldFromObject) < 0 ? 1 : 0] == kBaked)
            all += sizes[instance.mesh];
    for (std::size_t i = 0; i < uses.size(); ++i)
        for (const std::uint32_t range : uses[i].range)
            if (range != kBaked) all += sizes[i];
    if (all.vertices >= kNone || all.triangles >= kNone)
        throw FileError(scene.path.string(), "geometry: more than 2^32 vertices or triangles; split the scene");
    if (all.bytes() > physicalMemory())
        throw FileError(scene.path.string(),
                        fmt::format("geometry: {} placed triangles take {} MiB; this machine has {}", all.triangles,
                                    all.bytes() >> 20U, physicalMemory() >> 20U));
}

}  // namespace

GeometryPlan planGeometry(const Scene& scene, const FlattenOptions& options,
                          const std::vector<MaterialTraits>& traits) {
    std::vector<MeshUse> uses(scene.meshes.size());
    for (const MeshInstance& instance : scene.instances) {
        const double sign = handedness(instance.worldFromObject);
        if (sign != 0 && std::isfinite(sign)) ++uses[instance.mesh].places[sign < 0 ? 1 : 0];
    }

    GeometryPlan plan;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        for (std::size_t hand = 0; hand < 2; ++hand) {
            if (worthSharing(scene.meshes[i], uses[i].places[hand], options, traits)) {
                uses[i].range[hand] = plan.ranges++;
            }
        }
    }

    checkSize(scene, uses);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const MeshInstance& instance = scene.instances[i];
        const double sign = handedness(instance.worldFromObject);
        const std::size_t hand = sign < 0 ? 1 : 0;
        const std::uint32_t range = uses[instance.mesh].range[hand];
        if (range == kBaked) {
            addJobs(plan, scene.meshes[instance.mesh], instance.worldFromObject, i, kBaked);
        } else if (sign == 0 || !std::isfinite(sign)) {
            ++plan.droppedInstances;
        } else {
            // Two mirrors make none: the mesh is stored mirrored, its placement keeps the orientation.
            plan.shared.push_back(
                {range, i, hand == 1 ? instance.worldFromObject * kMirror : instance.worldFromObject});
        }
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
        for (std::size_t hand = 0; hand < 2; ++hand) {
            const std::uint32_t range = uses[i].range[hand];
            if (range != kBaked) addJobs(plan, scene.meshes[i], hand == 1 ? kMirror : glm::mat4(1), 0, range);
        }
    }
    return plan;
}

}  // namespace vkpt
