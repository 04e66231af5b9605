#include "gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "gltf/model.h"

namespace vkpt::gltf {
namespace {

// Accessors without bytes behind them are zeros: nothing in the file vouches for their count.
constexpr std::size_t kMostZeros = std::size_t{1} << 16;

std::uint32_t componentCount(const Document& document, std::size_t index, int type) {
    if (type == kUnknown) document.fail("accessors[{}].type: is none of glTF 2.0's", index);
    if (type >= TINYGLTF_TYPE_MAT2 && type <= TINYGLTF_TYPE_MAT4)
        document.fail("accessors[{}].type: MAT{} where a scalar or vector is needed", index,
                      type - TINYGLTF_TYPE_MAT2 + 2);
    return static_cast<std::uint32_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
}

std::size_t componentSize(int type) {
    return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

bool isUnsigned(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Points `span` at its bytes and proves that they are there.
void attach(const Document& document, const std::string& place, ElementSpan& span, std::size_t elementSize,
            std::size_t view, std::size_t offset) {
    const auto bytes = document.bufferView(view);
    const std::size_t stated = document.model().bufferViews[view].byteStride;
    const std::size_t stride = stated > 0 ? stated : elementSize;
    if (stride < elementSize)
        document.fail("bufferViews[{}].byteStride: {} is less than the {} bytes of an element of {}", view, stride,
                      elementSize, place);
    // count is at most 2^53 and stride may be as large: divide instead of multiplying.
    const bool fits = offset <= bytes.size() && elementSize <= bytes.size() - offset &&
                      span.count - 1 <= (bytes.size() - offset - elementSize) / stride;
    if (!fits) {
        const double needed =
            static_cast<double>(span.count - 1) * static_cast<double>(stride) + static_cast<double>(elementSize);
        document.fail("{}: needs {:.0f} bytes at offset {}, but bufferViews[{}] holds {}", place, needed, offset, view,
                      bytes.size());
    }
    span.data = bytes.data() + offset;
    span.stride = stride;
}

void openSparse(const Document& document, const std::string& place, const tinygltf::Accessor& source,
                Accessor& accessor) {
    const auto& indices = source.sparse.indices;
    const auto& values = source.sparse.values;
    const auto count = static_cast<std::size_t>(source.sparse.count);
    if (count > accessor.count())
        document.fail("{}.sparse.count: {} is more than the accessor's {}", place, count, accessor.count());

    accessor.sparseIndices = {nullptr, count, 0, indices.componentType, false};
    if (!isUnsigned(indices.componentType))
        document.fail("{}.sparse.indices.componentType: must be an unsigned integer", place);
    attach(document, place + ".sparse.indices", accessor.sparseIndices, componentSize(indices.componentType),
           static_cast<std::size_t>(indices.bufferView), static_cast<std::size_t>(indices.byteOffset));

    accessor.sparseValues = {nullptr, count, 0, accessor.dense.componentType, accessor.dense.normalized};
    attach(document, place + ".sparse.values", accessor.sparseValues,
           componentSize(accessor.dense.componentType) * accessor.components,
           static_cast<std::size_t>(values.bufferView), static_cast<std::size_t>(values.byteOffset));
}

// Calls `visit` with a value of the C++ type behind `componentType`.
template <typename Visit>
void dispatch(int componentType, Visit&& visit) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return visit(std::int8_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return visit(std::uint8_t{});
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return visit(std::int16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return visit(std::uint16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return visit(std::uint32_t{});
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return visit(float{});
    }
}

template <typename T>
T load(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);  // files need not honour alignment
    return value;
}

// Normalised integers: f = c / max, and no less than -1. [glTF 2.0, §3.6.2.2]
template <typename T, bool normalized>
float toFloat(T value) {
    if constexpr (std::is_same_v<T, float> || !normalized)
        return static_cast<float>(value);
    else
        return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
}

template <typename V, typename T, bool normalized>
V loadVector(const std::byte* from) {
    V vector;
    for (glm::length_t c = 0; c < V::length(); ++c)
        vector[c] = toFloat<T, normalized>(load<T>(from + static_cast<std::size_t>(c) * sizeof(T)));
    return vector;
}

// The one loop over vertices: element first + i goes to out[slot(i)].
template <typename V, typename Slot>
void convert(const ElementSpan& span, std::size_t first, std::size_t count, V* out, Slot&& slot) {
    const std::byte* from = span.data + first * span.stride;
    const std::size_t stride = span.stride;
    dispatch(span.componentType, [&](auto sample) {
        using T = decltype(sample);
        if (span.normalized)
            for (std::size_t i = 0; i < count; ++i) out[slot(i)] = loadVector<V, T, true>(from + i * stride);
        else
            for (std::size_t i = 0; i < count; ++i) out[slot(i)] = loadVector<V, T, false>(from + i * stride);
    });
}

std::vector<std::uint32_t> loadIntegers(const ElementSpan& span) {
    std::vector<std::uint32_t> values(span.count);
    if (span.data == nullptr) return values;
    dispatch(span.componentType, [&](auto sample) {
        using T = decltype(sample);
        for (std::size_t i = 0; i < span.count; ++i)
            values[i] = static_cast<std::uint32_t>(load<T>(span.data + i * span.stride));
    });
    return values;
}

// Positions of the sparse values, which must rise strictly. [glTF 2.0, §3.6.2.3]
std::vector<std::uint32_t> sparsePositions(const Document& document, const Accessor& accessor) {
    std::vector<std::uint32_t> at = loadIntegers(accessor.sparseIndices);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= accessor.count())
            document.fail("accessors[{}].sparse.indices: {} is past its {} elements", accessor.index, at[i],
                          accessor.count());
        if (i > 0 && at[i] <= at[i - 1])
            document.fail("accessors[{}].sparse.indices: must rise, but {} follows {}", accessor.index, at[i],
                          at[i - 1]);
    }
    return at;
}

}  // namespace

Accessor openAccessor(const Document& document, std::size_t index) {
    const tinygltf::Accessor& source = document.model().accessors[index];
    const std::string place = fmt::format("accessors[{}]", index);
    Accessor accessor;
    accessor.index = index;
    accessor.components = componentCount(document, index, source.type);
    if (source.componentType == kUnknown) document.fail("{}.componentType: is none of glTF 2.0's", place);
    accessor.dense.count = source.count;
    accessor.dense.componentType = source.componentType;
    accessor.dense.normalized = source.normalized;

    if (source.bufferView >= 0) {
        attach(document, place, accessor.dense, componentSize(accessor.dense.componentType) * accessor.components,
               static_cast<std::size_t>(source.bufferView), source.byteOffset);
    } else if (accessor.count() > kMostZeros) {
        document.fail("{}: states {} elements without a bufferView; at most {} are taken", place, accessor.count(),
                      kMostZeros);
    }
    if (source.sparse.isSparse) {
        openSparse(document, place, source, accessor);
        accessor.sparseAt = sparsePositions(document, accessor);
    }
    return accessor;
}

template <typename V>
std::vector<V> readVectors(const Accessor& accessor, std::size_t first, std::size_t count) {
    std::vector<V> out(count, V(0));
    if (accessor.dense.data != nullptr)
        convert(accessor.dense, first, count, out.data(), [](std::size_t i) { return i; });

    const auto& at = accessor.sparseAt;
    const auto begin = std::lower_bound(at.begin(), at.end(), first);
    const auto end = std::lower_bound(begin, at.end(), first + count);
    if (begin != end)
        convert(accessor.sparseValues, static_cast<std::size_t>(begin - at.begin()),
                static_cast<std::size_t>(end - begin), out.data(),
                [&](std::size_t i) { return begin[static_cast<std::ptrdiff_t>(i)] - first; });
    return out;
}

template std::vector<glm::vec2> readVectors(const Accessor&, std::size_t, std::size_t);
template std::vector<glm::vec3> readVectors(const Accessor&, std::size_t, std::size_t);
template std::vector<glm::vec4> readVectors(const Accessor&, std::size_t, std::size_t);

std::vector<std::uint32_t> readIndices(const Document& document, const Accessor& accessor) {
    if (accessor.components != 1 || accessor.dense.normalized || !isUnsigned(accessor.dense.componentType))
        document.fail("accessors[{}]: indices must be unsigned scalars", accessor.index);
    std::vector<std::uint32_t> values = loadIntegers(accessor.dense);
    const std::vector<std::uint32_t> replaced = loadIntegers(accessor.sparseValues);
    for (std::size_t i = 0; i < replaced.size(); ++i) values[accessor.sparseAt[i]] = replaced[i];
    return values;
}

}  // namespace vkpt::gltf
