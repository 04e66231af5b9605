// Triangle sets to build trees over.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene_arrays.h"

namespace vkpt {

using Triangles = std::vector<TriangleRecord>;

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    /// Uniform in [-1, 1), the same on every platform.
    float operator()() { return static_cast<float>(engine_() >> 8U) * 0x1p-23F - 1.0F; }
    vec3 vec() {
        const float x = (*this)(), y = (*this)(), z = (*this)();
        return {x, y, z};
    }

private:
    std::mt19937 engine_;
};

inline void addTriangle(Triangles& list, const vec3& a, const vec3& b, const vec3& c) {
    TriangleRecord t{};
    t.v0 = a, t.v1 = b, t.v2 = c;
    t.light = kNone;
    t.primitive = static_cast<std::uint32_t>(list.size());
    list.push_back(t);
}

inline Triangles soup(std::size_t n, float scale, float size, const vec3& offset = vec3(0)) {
    Random random(7);
    Triangles list;
    for (std::size_t i = 0; i < n; ++i) {
        const vec3 c = random.vec(), a = c + size * random.vec(), b = c + size * random.vec();
        addTriangle(list, offset + scale * a, offset + scale * b, offset + scale * c);
    }
    return list;
}

/// Needles up to a hundred thousand times as long as wide, across the whole volume.
inline Triangles slivers(std::size_t n) {
    Random random(11);
    Triangles list;
    for (std::size_t i = 0; i < n; ++i) {
        const vec3 a = random.vec(), b = random.vec();
        addTriangle(list, a, b, b + 1e-5F * random.vec());
    }
    return list;
}

/// Each triangle `copies` times.
inline Triangles duplicates(std::size_t n, std::size_t copies) {
    const Triangles once = soup(n, 1, 0.2F);
    Triangles list;
    for (std::size_t c = 0; c < copies; ++c) {
        for (const TriangleRecord& t : once) addTriangle(list, t.v0, t.v1, t.v2);
    }
    return list;
}

/// Concentric triangles, each a fraction of the one before: splits by area peel off few at a time.
inline Triangles nested(std::size_t n, float ratio) {
    Triangles list;
    float r = 1;
    for (std::size_t i = 0; i < n; ++i, r *= ratio) {
        addTriangle(list, {r, 0, 0.1F * r}, {-r, r, 0.2F * r}, {-0.5F * r, -r, r});
    }
    return list;
}

/// A displaced grid of 2 n^2 triangles whose neighbours share vertices exactly; height 0 is a flat plane y = 0.
inline Triangles grid(int n, float height) {
    const auto point = [&](int i, int j) {
        const float x = 2 * static_cast<float>(i) / static_cast<float>(n) - 1;
        const float z = 2 * static_cast<float>(j) / static_cast<float>(n) - 1;
        return vec3(x, height * std::sin(5 * x + 1) * std::cos(7 * z), z);
    };
    Triangles list;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            addTriangle(list, point(i, j), point(i, j + 1), point(i + 1, j));
            addTriangle(list, point(i + 1, j), point(i, j + 1), point(i + 1, j + 1));
        }
    }
    return list;
}

/// A closed unit sphere of 4 n^2 triangles, some of them degenerate at the poles.
inline Triangles sphere(int n) {
    const auto point = [&](int i, int j) {
        // The seam and the poles must close exactly.
        const double phi = (j % (2 * n)) * M_PI / n, theta = i * M_PI / n;
        const double r = i == 0 || i == n ? 0.0 : std::sin(theta);
        return vec3(glm::dvec3(r * std::cos(phi), std::cos(theta), r * std::sin(phi)));
    };
    Triangles list;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            addTriangle(list, point(i, j), point(i, j + 1), point(i + 1, j));
            addTriangle(list, point(i + 1, j), point(i, j + 1), point(i + 1, j + 1));
        }
    }
    return list;
}

struct NamedTriangles {
    std::string name;
    Triangles triangles;
};

/// Every kind of set that has its own way to break a builder.
inline std::vector<NamedTriangles> allSets() {
    Triangles point;
    for (int i = 0; i < 100; ++i) addTriangle(point, vec3(1, 2, 3), vec3(1, 2, 3), vec3(1, 2, 3));
    Triangles line;
    for (int i = 0; i < 500; ++i) {
        const auto x = static_cast<float>(i);
        addTriangle(line, vec3(x, 0, 0), vec3(x + 1, 0, 0), vec3(x + 2, 0, 0));
    }
    Triangles mixed = soup(300, 1, 0.1F);
    for (const TriangleRecord& t : soup(300, 1e12F, 0.1F)) addTriangle(mixed, t.v0, t.v1, t.v2);
    for (const TriangleRecord& t : soup(300, 1e-12F, 0.1F)) addTriangle(mixed, t.v0, t.v1, t.v2);
    return {{"empty", {}},
            {"single", soup(1, 1, 0.5F)},
            {"two", soup(2, 1, 0.5F)},
            {"three", soup(3, 1, 0.5F)},
            {"four", soup(4, 1, 0.5F)},
            {"nine", soup(9, 1, 0.5F)},
            {"the longest list", soup(kListMax, 1, 0.5F)},
            {"small triangles", soup(3000, 1, 0.03F)},
            {"large triangles", soup(1000, 1, 1.0F)},
            {"slivers", slivers(1000)},
            {"huge", soup(1000, 1e15F, 0.1F)},
            {"tiny", soup(1000, 1e-15F, 0.1F)},
            {"far from the origin", soup(1000, 1, 0.1F, vec3(1e5F, -3e6F, 2e4F))},
            {"duplicates", duplicates(20, 50)},
            {"flat plane", grid(20, 0)},
            {"grid", grid(30, 0.2F)},
            {"sphere", sphere(16)},
            {"nested", nested(150, 0.7F)},
            {"point", point},
            {"line", line},
            {"mixed scales", mixed}};
}

inline SceneArrays sceneOf(Triangles triangles) {
    SceneArrays arrays;
    arrays.meshRanges = {{0, static_cast<std::uint32_t>(triangles.size())}};
    arrays.triangles = std::move(triangles);
    return arrays;
}

}  // namespace vkpt
