#include "gltf/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gltf/accessor.h"
#include "gltf/normals.h"
#include "gltf/tangents.h"
#include "gltf/topology.h"

namespace vkpt::gltf {
namespace {

/// The vertices that the primitive's triangles use lie in [first, first + count): many primitives may share one
/// accessor, so only this range is read.
struct VertexRange {
    std::size_t first = 0, count = 0;
};

template <typename V>
bool isFiniteVector(const V& v) {
    for (glm::length_t i = 0; i < V::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

/// Float arithmetic can normalise it.
bool hasDirection(const glm::vec3& v) {
    const float squared = glm::dot(v, v);
    return squared >= std::numeric_limits<float>::min() && squared <= std::numeric_limits<float>::max();
}

class PrimitiveReader {
public:
    PrimitiveReader(const Document& document, const tinygltf::Primitive& source, std::string place,
                    std::vector<std::string>& warnings)
        : document_(document), source_(source), place_(std::move(place)), warnings_(warnings) {}

    std::optional<Primitive> read(const Material& material, Skipped& skipped);

private:
    [[nodiscard]] std::optional<Accessor> openAttribute(const char* name, std::uint32_t least,
                                                        std::uint32_t most) const;
    [[nodiscard]] std::vector<std::uint32_t> vertexOrder() const;
    template <typename V>
    [[nodiscard]] std::vector<V> attribute(const char* name, std::uint32_t components) const;
    void readAttributes(Primitive& primitive) const;
    void readColors(Primitive& primitive) const;
    template <typename V, typename Usable>
    void require(const std::vector<V>& values, const char* name, const char* fault, Usable&& usable) const;
    void checkTextureCoordinates(const Primitive& primitive, const Material& material) const;
    void finishShading(Primitive& primitive, const Material& material) const;

    const Document& document_;
    const tinygltf::Primitive& source_;
    std::string place_;
    std::vector<std::string>& warnings_;
    std::optional<Accessor> positions_;
    VertexRange range_;
};

/// Opens an attribute and checks what the specification demands of all of them; none where it is absent.
std::optional<Accessor> PrimitiveReader::openAttribute(const char* name, std::uint32_t least,
                                                       std::uint32_t most) const {
    const auto index = source_.attributes.find(name);
    if (index == source_.attributes.end()) return std::nullopt;
    Accessor accessor = openAccessor(document_, static_cast<std::size_t>(index->second));
    if (accessor.components < least || accessor.components > most)
        document_.fail("{}.attributes.{}: accessors[{}] has {} components, not {}", place_, name, accessor.index,
                       accessor.components, least);
    if (accessor.dense.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        document_.fail("{}.attributes.{}: accessors[{}] holds 32-bit integers, which only indices may", place_, name,
                       accessor.index);
    if (positions_ && accessor.count() != positions_->count())
        document_.fail("{}.attributes.{}: has {} elements, but POSITION has {}", place_, name, accessor.count(),
                       positions_->count());
    return accessor;
}

/// Indices of the vertices in drawing order.
std::vector<std::uint32_t> PrimitiveReader::vertexOrder() const {
    std::vector<std::uint32_t> order;
    if (source_.indices < 0) {
        order.resize(positions_->count());
        std::iota(order.begin(), order.end(), 0U);
        return order;
    }
    const Accessor accessor = openAccessor(document_, static_cast<std::size_t>(source_.indices));
    order = readIndices(document_, accessor);
    const auto past =
        std::find_if(order.begin(), order.end(), [&](std::uint32_t i) { return i >= positions_->count(); });
    if (past != order.end())
        document_.fail("{}.indices: accessors[{}][{}] is {}, but there are {} vertices", place_, accessor.index,
                       past - order.begin(), *past, positions_->count());
    return order;
}

/// Names the first value that is not usable.
template <typename V, typename Usable>
void PrimitiveReader::require(const std::vector<V>& values, const char* name, const char* fault,
                              Usable&& usable) const {
    const auto bad = std::find_if_not(values.begin(), values.end(), usable);
    if (bad != values.end())
        document_.fail("{}.attributes.{}: accessors[{}][{}] {}", place_, name, source_.attributes.at(name),
                       range_.first + static_cast<std::size_t>(bad - values.begin()), fault);
}

template <typename V>
std::vector<V> PrimitiveReader::attribute(const char* name, std::uint32_t components) const {
    const auto accessor = openAttribute(name, components, components);
    if (!accessor) return {};
    std::vector<V> values = readVectors<V>(*accessor, range_.first, range_.count);
    require(values, name, "is not finite", isFiniteVector<V>);
    return values;
}

/// COLOR_0: integers are normalised even where the file forgets to say so, since no others are allowed.
void PrimitiveReader::readColors(Primitive& primitive) const {
    auto accessor = openAttribute("COLOR_0", 3, 4);
    if (!accessor) return;
    accessor->dense.normalized = accessor->sparseValues.normalized = true;
    if (accessor->components == 4) {
        primitive.colors = readVectors<glm::vec4>(*accessor, range_.first, range_.count);
    } else {
        const auto rgb = readVectors<glm::vec3>(*accessor, range_.first, range_.count);
        primitive.colors.reserve(rgb.size());
        for (const glm::vec3& c : rgb) primitive.colors.emplace_back(c, 1.0F);
    }
    require(primitive.colors, "COLOR_0", "is not finite", isFiniteVector<glm::vec4>);
    for (glm::vec4& c : primitive.colors) c = glm::clamp(c, 0.0F, 1.0F);
}

void PrimitiveReader::readAttributes(Primitive& primitive) const {
    primitive.positions = attribute<glm::vec3>("POSITION", 3);
    primitive.normals = attribute<glm::vec3>("NORMAL", 3);
    require(primitive.normals, "NORMAL", "has no direction", hasDirection);
    for (glm::vec3& normal : primitive.normals) normal = glm::normalize(normal);
    primitive.uv0 = attribute<glm::vec2>("TEXCOORD_0", 2);
    primitive.uv1 = attribute<glm::vec2>("TEXCOORD_1", 2);
    readColors(primitive);
}

/// Every texture of the material finds the coordinates that it is read at.
void PrimitiveReader::checkTextureCoordinates(const Primitive& primitive, const Material& material) const {
    for (const TextureUse* use : {&material.baseColorTexture, &material.metallicRoughnessTexture,
                                  &material.normalTexture, &material.emissiveTexture})
        if (use->image >= 0 && (use->uvSet == 0 ? primitive.uv0 : primitive.uv1).empty())
            document_.fail("{}: has no TEXCOORD_{}, which materials[{}] reads", place_, use->uvSet, source_.material);
}

void PrimitiveReader::finishShading(Primitive& primitive, const Material& material) const {
    const bool flat = primitive.normals.empty();
    if (flat) makeFlat(primitive);
    if (material.normalTexture.image < 0 && !(material.bsdf && isAnisotropic(*material.bsdf))) return;
    if (!flat) {  // tangents without normals would belong to other ones [glTF 2.0, §3.7.2.1]
        primitive.tangents = attribute<glm::vec4>("TANGENT", 4);
        require(primitive.tangents, "TANGENT", "has no direction", hasDirection);
        require(primitive.tangents, "TANGENT", "has no handedness", [](const glm::vec4& t) { return t.w != 0; });
    }
    if (primitive.tangents.empty()) makeTangents(primitive, material.normalTexture.uvSet);
}

std::optional<Primitive> PrimitiveReader::read(const Material& material, Skipped& skipped) {
    if (source_.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        document_.fail("{}.mode: {} is none of glTF's", place_, source_.mode);
    const Mode mode = static_cast<Mode>(source_.mode);

    positions_ = openAttribute("POSITION", 3, 3);
    if (!positions_) {
        warnings_.push_back(fmt::format("{}: has no POSITION and is skipped", place_));
        return std::nullopt;
    }
    const std::vector<std::uint32_t> order = vertexOrder();
    if (mode < Mode::Triangles) {
        (mode == Mode::Points ? skipped.points : skipped.lines) +=
            mode == Mode::Points ? order.size() : lineCount(mode, order.size());
        return std::nullopt;
    }

    Primitive primitive;
    primitive.triangles = assembleTriangles(mode, order);
    if (mode == Mode::Triangles && order.size() % 3 != 0)
        warnings_.push_back(fmt::format("{}: {} vertices are no whole number of triangles", place_, order.size()));
    if (primitive.triangles.empty()) return std::nullopt;

    const auto [low, high] = std::minmax_element(order.begin(), order.end());
    range_ = {*low, std::size_t{*high} - *low + 1};
    document_.countElements(range_.count + order.size());
    for (glm::uvec3& t : primitive.triangles) t -= glm::uvec3(*low);
    readAttributes(primitive);
    checkTextureCoordinates(primitive, material);
    finishShading(primitive, material);
    return primitive;
}

}  // namespace

std::optional<Primitive> readPrimitive(const Document& document, std::size_t mesh, std::size_t index,
                                       const Material& material, Skipped& skipped, std::vector<std::string>& warnings) {
    return PrimitiveReader(document, document.model().meshes[mesh].primitives[index],
                           fmt::format("meshes[{}].primitives[{}]", mesh, index), warnings)
        .read(material, skipped);
}

}  // namespace vkpt::gltf
