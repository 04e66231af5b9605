// Primitive modes: what a list of vertices draws. [glTF 2.0, §3.7.2.1]
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace vkpt::gltf {

enum class Mode : std::uint32_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// Line segments drawn by `count` vertices.
[[nodiscard]] std::uint64_t lineCount(Mode mode, std::uint64_t count);

/// Triangles drawn by vertices `order`, wound as the specification says. Those that use a vertex twice, as strips do to
/// turn corners, are left out; so are vertices at the end that make no whole triangle.
[[nodiscard]] std::vector<glm::uvec3> assembleTriangles(Mode mode, const std::vector<std::uint32_t>& order);

}  // namespace vkpt::gltf
