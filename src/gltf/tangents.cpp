#include "gltf/tangents.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

namespace vkpt::gltf {
namespace {

constexpr std::uint32_t kNoVertex = 0xffffffffU;
constexpr std::size_t kGrain = 4096;  // vertices or triangles a task

/// How a triangle's texture lies on it.
enum class Handedness : std::int8_t { Mirrored = -1, None = 0, Plain = 1 };

/// Per triangle: the direction in which U grows, scaled by nothing, and on which side the texture is seen.
struct Gradient {
    glm::vec3 alongU{0};
    Handedness handedness = Handedness::None;
};

// dP/du up to a positive factor. Solves the two edges for it. [Mikkelsen 08, §3.1]
Gradient gradient(const Primitive& p, const std::vector<glm::vec2>& uv, const glm::uvec3& t) {
    const glm::vec3 d1 = p.positions[t.y] - p.positions[t.x], d2 = p.positions[t.z] - p.positions[t.x];
    const glm::vec2 t1 = uv[t.y] - uv[t.x], t2 = uv[t.z] - uv[t.x];
    const float area = t1.x * t2.y - t1.y * t2.x;
    if (!(std::abs(area) > std::numeric_limits<float>::min())) return {};
    const glm::vec3 alongU = (d1 * t2.y - d2 * t1.y) * (area > 0 ? 1.0F : -1.0F);
    const float length = glm::length(alongU);
    if (!(length > 0) || !std::isfinite(length)) return {};
    // V points down: a texture that is not mirrored has negative area in glTF's coordinates.
    return {alongU / length, area < 0 ? Handedness::Plain : Handedness::Mirrored};
}

/// Maps every vertex to the first vertex equal to it in position, normal and texture coordinate.
std::vector<std::uint32_t> weld(const Primitive& p, const std::vector<glm::vec2>& uv) {
    using Key = std::array<std::uint32_t, 8>;
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0F); };  // -0 equals 0
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 &a = p.positions[i], &n = p.normals[i];
        return Key{bits(a.x), bits(a.y), bits(a.z), bits(n.x), bits(n.y), bits(n.z), bits(uv[i].x), bits(uv[i].y)};
    };
    const auto count = static_cast<std::uint32_t>(p.positions.size());
    const std::uint64_t mask = std::bit_ceil(std::uint64_t{count} * 2) - 1;
    std::vector<std::uint32_t> slots(mask + 1, kNoVertex), first(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Key mine = key(i);
        std::uint64_t hash = 0;
        for (const std::uint32_t word : mine) hash = (std::rotl(hash, 23) ^ word) * 0x9e3779b97f4a7c15ULL;
        std::uint64_t slot = (hash ^ hash >> 32) & mask;
        while (slots[slot] != kNoVertex && key(slots[slot]) != mine) slot = (slot + 1) & mask;
        if (slots[slot] == kNoVertex) slots[slot] = i;
        first[i] = slots[slot];
    }
    return first;
}

/// Corners (3 * triangle + corner) around each welded vertex, one list after the other.
struct Fans {
    std::vector<std::uint32_t> begin;  // by welded vertex, one more than there are
    std::vector<std::uint32_t> corners;
};

Fans collectFans(const std::vector<glm::uvec3>& triangles, const std::vector<std::uint32_t>& welded) {
    Fans fans;
    fans.begin.assign(welded.size() + 1, 0);
    for (const glm::uvec3& t : triangles)
        for (glm::length_t c = 0; c < 3; ++c) ++fans.begin[welded[t[c]] + 1];
    std::partial_sum(fans.begin.begin(), fans.begin.end(), fans.begin.begin());
    fans.corners.resize(triangles.size() * 3);
    std::vector<std::uint32_t> next(fans.begin.begin(), fans.begin.end() - 1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::uint32_t c = 0; c < 3; ++c)
            fans.corners[next[welded[triangles[i][static_cast<glm::length_t>(c)]]]++] = 3 * i + c;
    return fans;
}

/// Splits the corners around one vertex into groups that share a tangent, and computes it.
class Fan {
public:
    Fan(const Primitive& primitive, const std::vector<Gradient>& gradients, const std::vector<std::uint32_t>& welded)
        : primitive_(primitive), gradients_(gradients), welded_(welded) {}

    /// Writes the tangent of every corner of `corners` into `out`, by corner.
    void solve(std::span<const std::uint32_t> corners, std::vector<glm::vec4>& out) {
        corners_ = corners;
        group();
        sums_.assign(corners.size(), glm::vec3(0));
        for (std::size_t i = 0; i < corners.size(); ++i) sums_[find(i)] += weighted(corners[i]);
        for (std::size_t i = 0; i < corners.size(); ++i) out[corners[i]] = tangent(i);
    }

private:
    /// The far end of one of the two edges at a corner.
    struct Spoke {
        std::uint32_t far;
        std::uint32_t member;
        bool outgoing;  // the triangle walks this edge away from the vertex
        auto operator<=>(const Spoke&) const = default;
    };

    [[nodiscard]] std::uint32_t vertexAt(std::uint32_t corner, std::uint32_t step) const {
        return primitive_.triangles[corner / 3][static_cast<glm::length_t>((corner % 3 + step) % 3)];
    }

    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    // Joins corners across edges that two triangles walk in opposite directions. Triangles without a gradient take the
    // handedness of a neighbour, so they neither part a group nor join two of different handedness.
    void group() {
        parent_.resize(corners_.size());
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        handedness_.resize(corners_.size());
        spokes_.clear();
        for (std::uint32_t i = 0; i < corners_.size(); ++i) {
            handedness_[i] = gradients_[corners_[i] / 3].handedness;
            spokes_.push_back({welded_[vertexAt(corners_[i], 1)], i, true});
            spokes_.push_back({welded_[vertexAt(corners_[i], 2)], i, false});
        }
        std::sort(spokes_.begin(), spokes_.end());
        for (int pass = 0; pass < kMaxPasses && joinNeighbours(); ++pass) {
        }
    }

    // One pass over the edges; true where a triangle took on a handedness, so that another pass may join more.
    bool joinNeighbours() {
        bool adopted = false;
        for (std::size_t begin = 0, end = 0; begin < spokes_.size(); begin = end) {
            while (end < spokes_.size() && spokes_[end].far == spokes_[begin].far) ++end;
            for (std::size_t a = begin; a < end; ++a)
                for (std::size_t b = a + 1; b < end && b <= a + kMaxEdgeMates; ++b) {
                    if (spokes_[a].outgoing != spokes_[b].outgoing)
                        adopted |= join(spokes_[a].member, spokes_[b].member);
                }
        }
        return adopted;
    }

    bool join(std::uint32_t a, std::uint32_t b) {
        bool adopted = false;
        if (handedness_[a] == Handedness::None && handedness_[b] != Handedness::None) {
            handedness_[a] = handedness_[b];
            adopted = true;
        } else if (handedness_[b] == Handedness::None && handedness_[a] != Handedness::None) {
            handedness_[b] = handedness_[a];
            adopted = true;
        }
        if (handedness_[a] == handedness_[b] && handedness_[a] != Handedness::None) parent_[find(a)] = find(b);
        return adopted;
    }

    // A corner's part in its group's sum: its gradient in the tangent plane, times the angle there. [Mikkelsen 08,
    // §3.3]
    [[nodiscard]] glm::vec3 weighted(std::uint32_t corner) const {
        const Gradient& g = gradients_[corner / 3];
        if (g.handedness == Handedness::None) return glm::vec3(0);
        const std::uint32_t here = vertexAt(corner, 0);
        const glm::vec3& n = primitive_.normals[here];
        const auto project = [&](const glm::vec3& v) {
            const glm::vec3 flat = v - n * glm::dot(n, v);
            const float length = glm::length(flat);
            return length > 0 && std::isfinite(length) ? flat / length : glm::vec3(0);
        };
        const glm::vec3& p = primitive_.positions[here];
        const glm::vec3 a = project(primitive_.positions[vertexAt(corner, 1)] - p);
        const glm::vec3 b = project(primitive_.positions[vertexAt(corner, 2)] - p);
        return project(g.alongU) * std::acos(std::clamp(glm::dot(a, b), -1.0F, 1.0F));
    }

    glm::vec4 tangent(std::size_t member) {
        const std::size_t root = find(member);
        const glm::vec3& n = primitive_.normals[vertexAt(corners_[member], 0)];
        const float length = glm::length(sums_[root]);
        const float w = handedness_[member] == Handedness::Mirrored ? -1.0F : 1.0F;
        if (length > kNoDirection) return {sums_[root] / length, w};
        const glm::vec3 axis = std::abs(n.x) < 0.5F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        return {glm::normalize(axis - n * glm::dot(n, axis)), w};
    }

    static constexpr std::size_t kMaxEdgeMates = 8;  // edges with more triangles than this are not smoothed over fully
    static constexpr int kMaxPasses = 64;            // bounds long runs of triangles without a gradient
    static constexpr float kNoDirection = 1e-12F;

    const Primitive& primitive_;
    const std::vector<Gradient>& gradients_;
    const std::vector<std::uint32_t>& welded_;
    std::span<const std::uint32_t> corners_;
    std::vector<std::size_t> parent_;
    std::vector<Handedness> handedness_;
    std::vector<Spoke> spokes_;
    std::vector<glm::vec3> sums_;
};

template <typename T>
void appendCopy(std::vector<T>& values, std::uint32_t i) {
    if (!values.empty()) values.push_back(T(values[i]));
}

/// Gives every vertex one tangent; corners that disagree get vertices of their own.
void assign(Primitive& primitive, const std::vector<glm::vec4>& byCorner) {
    const std::size_t original = primitive.positions.size();
    std::vector<bool> taken(original, false);
    std::vector<std::uint32_t> nextCopy(original, kNoVertex);  // chain of the vertices split from one
    primitive.tangents.assign(original, glm::vec4(1, 0, 0, 1));
    for (std::size_t corner = 0; corner < byCorner.size(); ++corner) {
        std::uint32_t& vertex = primitive.triangles[corner / 3][static_cast<glm::length_t>(corner % 3)];
        if (!taken[vertex]) {
            taken[vertex] = true;
            primitive.tangents[vertex] = byCorner[corner];
            continue;
        }
        while (primitive.tangents[vertex] != byCorner[corner] && nextCopy[vertex] != kNoVertex)
            vertex = nextCopy[vertex];
        if (primitive.tangents[vertex] == byCorner[corner]) continue;
        const auto copy = static_cast<std::uint32_t>(primitive.positions.size());
        appendCopy(primitive.positions, vertex);
        appendCopy(primitive.normals, vertex);
        appendCopy(primitive.uv0, vertex);
        appendCopy(primitive.uv1, vertex);
        appendCopy(primitive.colors, vertex);
        primitive.tangents.push_back(byCorner[corner]);
        nextCopy.push_back(kNoVertex);
        nextCopy[vertex] = copy;
        vertex = copy;
    }
}

}  // namespace

void makeTangents(Primitive& primitive, std::uint32_t uvSet) {
    const std::vector<glm::vec2>& stored = uvSet == 0 ? primitive.uv0 : primitive.uv1;
    const std::vector<glm::vec2> none(stored.empty() ? primitive.positions.size() : 0, glm::vec2(0));
    const std::vector<glm::vec2>& uv = stored.empty() ? none : stored;

    std::vector<Gradient> gradients(primitive.triangles.size());
    const auto range = [](std::size_t count) { return tbb::blocked_range<std::size_t>(0, count, kGrain); };
    tbb::parallel_for(range(gradients.size()), [&](const auto& part) {
        for (std::size_t i = part.begin(); i < part.end(); ++i)
            gradients[i] = gradient(primitive, uv, primitive.triangles[i]);
    });

    const std::vector<std::uint32_t> welded = weld(primitive, uv);
    const Fans fans = collectFans(primitive.triangles, welded);
    std::vector<glm::vec4> byCorner(primitive.triangles.size() * 3);
    tbb::parallel_for(range(welded.size()), [&](const auto& part) {
        Fan fan(primitive, gradients, welded);
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
            const auto corners = std::span(fans.corners).subspan(fans.begin[i], fans.begin[i + 1] - fans.begin[i]);
            if (!corners.empty()) fan.solve(corners, byCorner);
        }
    });
    assign(primitive, byCorner);
}

}  // namespace vkpt::gltf
