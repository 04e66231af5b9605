// Typed reading of accessors: every component type, stride and sparse form. [glTF 2.0, §3.6.2]
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gltf/document.h"

namespace vkpt::gltf {

/// Elements in memory: `count` of them, `stride` bytes apart, wholly inside their buffer view.
struct ElementSpan {
    const std::byte* data = nullptr;  ///< null: all zeros
    std::size_t count = 0, stride = 0;
    int componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    bool normalized = false;
};

/// One accessor, validated: its ranges lie inside their buffer views. Reading it cannot fail but by the values.
struct Accessor {
    std::size_t index = 0;
    std::uint32_t components = 1;  ///< of an element: SCALAR 1 to VEC4 4
    ElementSpan dense;
    ElementSpan sparseIndices, sparseValues;  ///< count 0: not sparse
    std::vector<std::uint32_t> sparseAt;      ///< which elements the sparse values replace, rising
    [[nodiscard]] std::size_t count() const { return dense.count; }
};

/// Throws FileError where the accessor is no vector of 1 to 4 components or does not fit its buffer views.
[[nodiscard]] Accessor openAccessor(const Document& document, std::size_t index);

/// Elements [first, first + count) as floats, normalised integers mapped to [0,1] or [-1,1]. The accessor must have at
/// least V's number of components; more are dropped.
template <typename V>
[[nodiscard]] std::vector<V> readVectors(const Accessor& accessor, std::size_t first, std::size_t count);

extern template std::vector<glm::vec2> readVectors(const Accessor&, std::size_t, std::size_t);
extern template std::vector<glm::vec3> readVectors(const Accessor&, std::size_t, std::size_t);
extern template std::vector<glm::vec4> readVectors(const Accessor&, std::size_t, std::size_t);

/// All elements of an accessor of indices. Throws FileError unless it is an unsigned, not normalised scalar.
[[nodiscard]] std::vector<std::uint32_t> readIndices(const Document& document, const Accessor& accessor);

}  // namespace vkpt::gltf
