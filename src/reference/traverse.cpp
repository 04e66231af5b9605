#include "reference/traverse.h"

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "reference/intersect.h"
#include "reference/material.h"

namespace vkpt::reference {

namespace {

constexpr std::uint32_t kSlots = 8;
constexpr std::size_t kStackSize = 512;  // 8 entries a level, 32 levels, with room to spare

/// A child that the ray meets: an inner node (count 0) or `count` items from `first` onwards.
struct Child {
    float tNear;
    std::uint32_t first, count;
};

/// Bytes of a node's slots: loX loY loZ hiX hiY hiZ, eight each.
using SlotBytes = std::array<std::array<std::uint8_t, kSlots>, 6>;
static_assert(sizeof(WideNode) - offsetof(WideNode, loX0) == sizeof(SlotBytes));

SlotBytes slotBytes(const WideNode& node) {
    SlotBytes bytes;
    std::memcpy(&bytes, reinterpret_cast<const std::byte*>(&node) + offsetof(WideNode, loX0), sizeof bytes);
    return bytes;
}

float cellSize(const WideNode& node, int axis) {
    return std::bit_cast<float>(((node.exponents >> (8 * axis)) & 0xffU) << 23U);
}

/// Largest distance along an axis from `p` to what lies under the root: bounds every rounding error of the tests.
float reachOf(const WideNode& root, const glm::vec3& p) {
    float reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float far = root.origin[axis] + 255.0F * cellSize(root, axis);
        reach = std::max({reach, std::abs(root.origin[axis] - p[axis]), std::abs(far - p[axis])});
    }
    return reach;
}

struct Slabs {
    std::array<float, kSlots> tNear, tFar;
};

/// Ray against the eight boxes of a node, slab by slab.
Slabs intersectBoxes(const WideNode& node, const BoxRay& ray) {
    const SlotBytes bytes = slotBytes(node);
    Slabs slabs;
    slabs.tNear.fill(0.0F);
    slabs.tFar.fill(std::numeric_limits<float>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
        const float cell = cellSize(node, axis), p = node.origin[axis];
        const float o = ray.origin[axis], inverse = ray.inverse[axis];
        const auto& lower = bytes[static_cast<std::size_t>(axis)];
        const auto& upper = bytes[static_cast<std::size_t>(axis) + 3];
        for (std::size_t s = 0; s < kSlots; ++s) {
            const float t0 = ((p + static_cast<float>(lower[s]) * cell) - o - ray.pad) * inverse;
            const float t1 = ((p + static_cast<float>(upper[s]) * cell) - o + ray.pad) * inverse;
            slabs.tNear[s] = std::max(slabs.tNear[s], std::min(t0, t1));
            slabs.tFar[s] = std::min(slabs.tFar[s], std::max(t0, t1));
        }
    }
    return slabs;
}

/// The child in slot s, decoded from its meta byte. [Ylitie 17, sec. 3]; count 0 marks an inner node.
Child childOf(const WideNode& node, std::uint32_t s, std::uint32_t meta, float tNear) {
    if (const std::uint32_t innerMask = node.exponents >> 24U; (innerMask >> s) & 1U) {
        const std::uint32_t before = innerMask & ((1U << s) - 1U);
        return {tNear, node.childBase + static_cast<std::uint32_t>(std::popcount(before)), 0};
    }
    return {tNear, node.itemBase + (meta & 31U), static_cast<std::uint32_t>(std::popcount(meta >> 5U))};
}

/// Children of the node that the ray enters before tMax, the farthest first. Returns how many.
std::size_t childrenMet(const WideNode& node, const BoxRay& ray, float tMax, std::array<Child, kSlots>& met) {
    const Slabs slabs = intersectBoxes(node, ray);
    std::size_t count = 0;
    for (std::uint32_t s = 0; s < kSlots; ++s) {
        const std::uint32_t meta = ((s < 4 ? node.meta0 : node.meta1) >> (8 * (s & 3U))) & 0xffU;
        if (meta == 0 || slabs.tNear[s] > std::min(slabs.tFar[s], tMax) * kRobustFar) continue;
        const Child child = childOf(node, s, meta, slabs.tNear[s]);
        std::size_t place = count++;
        for (; place > 0 && met[place - 1].tNear < child.tNear; --place) met[place] = met[place - 1];
        met[place] = child;
    }
    return count;
}

/// Visits the items under `root` that the ray may meet, near to far. visit(item) returns true to end the search;
/// tMax is read anew before every step, so a visit that lowers it prunes what follows.
template <class Visit>
bool visitItems(const SceneArrays& scene, std::uint32_t root, const BoxRay& ray, const float& tMax, SearchCost& cost,
                Visit&& visit) {
    std::array<Child, kStackSize> stack;
    std::size_t size = 0;
    stack[size++] = {0.0F, root, 0};
    std::array<Child, kSlots> met;
    while (size > 0) {
        const Child child = stack[--size];
        if (child.tNear > tMax * kRobustFar) continue;
        for (std::uint32_t i = 0; i < child.count; ++i) {
            if (visit(child.first + i)) return true;
        }
        if (child.count > 0) continue;
        ++cost.nodes;
        const std::size_t count = childrenMet(scene.nodes[child.first], ray, tMax, met);
        if (size + count > kStackSize) throw std::logic_error("the BVH is deeper than the traversal's stack");
        for (std::size_t i = 0; i < count; ++i) stack[size++] = met[i];
    }
    return false;
}

/// One query: the nearest hit so far, and whether the first one found is enough.
class Query {
public:
    Query(const SceneArrays& scene, std::uint32_t alphaKey, float tMax, bool any)
        : scene_(scene), alphaKey_(alphaKey), any_(any) {
        best_.t = tMax;
    }

    void run(const Ray& ray) {
        if (scene_.nodes.empty()) return;
        if (scene_.instances.empty()) {
            searchMesh(ray, scene_.rootNode, kNone);
            return;
        }
        const float size = std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
        // Instances move the ray's origin, which rounds by its size.
        const BoxRay boxRay(ray, reachOf(scene_.nodes[scene_.rootNode], ray.origin) + size);
        visitItems(scene_, scene_.rootNode, boxRay, best_.t, cost_, [&](std::uint32_t instance) {
            const InstanceRecord& record = scene_.instances[instance];
            const Ray local{transformPoint(record.objectFromWorld, ray.origin),
                            transformVector(record.objectFromWorld, ray.direction)};
            return searchMesh(local, record.rootNode, instance);
        });
    }

    [[nodiscard]] const Hit& best() const { return best_; }
    [[nodiscard]] const SearchCost& cost() const { return cost_; }

private:
    bool searchMesh(const Ray& ray, std::uint32_t root, std::uint32_t instance) {
        const ShearedRay sheared(ray);
        const BoxRay boxRay(ray, reachOf(scene_.nodes[root], ray.origin));
        return visitItems(scene_, root, boxRay, best_.t, cost_,
                          [&](std::uint32_t slot) { return testTriangle(sheared, slot, instance) && any_; });
    }

    bool testTriangle(const ShearedRay& ray, std::uint32_t slot, std::uint32_t instance) {
        const TriangleRecord& triangle = scene_.triangles[slot];
        ++cost_.triangles;
        const auto hit = ray.intersect(triangle.v0, triangle.v1, triangle.v2);
        if (!hit) return false;
        if ((triangle.flags & kTriangleSingleSided) != 0 && !hit->front) return false;
        const Hit candidate{hit->t, hit->barycentrics, slot, instance};
        if (!isNearer(candidate)) return false;
        if ((triangle.flags & kTriangleHasAlpha) != 0 && !isPresent(scene_, candidate, alphaKey_)) return false;
        best_ = candidate;
        return true;
    }

    [[nodiscard]] bool isNearer(const Hit& hit) const {
        if (hit.t != best_.t) return hit.t < best_.t;
        if (best_.triangle == kNone) return false;
        const std::uint32_t mine = scene_.triangles[hit.triangle].primitive;
        const std::uint32_t theirs = scene_.triangles[best_.triangle].primitive;
        return mine != theirs ? mine < theirs : hit.instance < best_.instance;
    }

    const SceneArrays& scene_;
    Hit best_;
    SearchCost cost_;
    std::uint32_t alphaKey_;
    bool any_;
};

}  // namespace

std::optional<Hit> closestHit(const SceneArrays& scene, const Ray& ray, std::uint32_t alphaKey, SearchCost* cost) {
    Query query(scene, alphaKey, std::numeric_limits<float>::infinity(), false);
    query.run(ray);
    if (cost != nullptr) {
        cost->nodes += query.cost().nodes;
        cost->triangles += query.cost().triangles;
    }
    if (query.best().triangle == kNone) return std::nullopt;
    return query.best();
}

bool anyHit(const SceneArrays& scene, const Ray& ray, float tMax, std::uint32_t alphaKey) {
    Query query(scene, alphaKey, tMax, true);
    query.run(ray);
    return query.best().triangle != kNone;
}

}  // namespace vkpt::reference
