#include "gltf/topology.h"

namespace vkpt::gltf {

std::uint64_t lineCount(Mode mode, std::uint64_t count) {
    if (count < 2) return 0;
    switch (mode) {
        case Mode::Lines:
            return count / 2;
        case Mode::LineLoop:
            return count;
        case Mode::LineStrip:
            return count - 1;
        default:
            return 0;
    }
}

std::vector<glm::uvec3> assembleTriangles(Mode mode, const std::vector<std::uint32_t>& order) {
    std::vector<glm::uvec3> triangles;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const glm::uvec3 t(order[a], order[b], order[c]);
        if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
    };
    const std::size_t n = order.size();
    if (n < 3) return triangles;
    triangles.reserve(mode == Mode::Triangles ? n / 3 : n - 2);
    if (mode == Mode::Triangles)
        for (std::size_t i = 0; i + 2 < n; i += 3) add(i, i + 1, i + 2);
    if (mode == Mode::TriangleStrip)
        for (std::size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    if (mode == Mode::TriangleFan)
        for (std::size_t i = 0; i + 2 < n; ++i) add(i + 1, i + 2, 0);
    return triangles;
}

}  // namespace vkpt::gltf
