// Component types, strides, sparse accessors, bounds. Observed through TEXCOORD_0, POSITION and indices.
#include <cstring>
#include <limits>

#include "builder.h"

namespace vkpt::test {
namespace {

using testing::HasSubstr;

template <typename T>
class ComponentTest : public testing::Test {};
using AttributeTypes = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ComponentTest, AttributeTypes);

// Three texture coordinates that reach the ends of the type's range.
template <typename T>
std::vector<T> samples() {
    using Limits = std::numeric_limits<T>;
    return {0, 1, Limits::max(), Limits::lowest(), 100, 7};
}

TYPED_TEST(ComponentTest, IntegersReadAsTheyAre) {
    using T = TypeParam;
    Builder b;
    Json& primitive = b.triangle();
    const auto in = samples<T>();
    primitive["attributes"]["TEXCOORD_0"] = b.accessor<T>(in, "VEC2", 2, false);
    const auto uv = b.importPrimitive().uv0;
    ASSERT_EQ(uv.size(), 3U);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(uv[i / 2][static_cast<glm::length_t>(i % 2)], static_cast<float>(in[i]));
}

TYPED_TEST(ComponentTest, NormalisedIntegersSpanTheUnitInterval) {
    using T = TypeParam;
    if constexpr (!std::is_same_v<T, float>) {  // floats are never normalised
        Builder b;
        Json& primitive = b.triangle();
        primitive["attributes"]["TEXCOORD_0"] = b.accessor<T>(samples<T>(), "VEC2", 2, true);
        const auto uv = b.importPrimitive().uv0;
        const auto max = static_cast<float>(std::numeric_limits<T>::max());
        EXPECT_EQ(uv[0], glm::vec2(0, 1 / max));
        EXPECT_EQ(uv[1], glm::vec2(1, std::is_signed_v<T> ? -1 : 0));  // the lowest integer is clamped
        EXPECT_EQ(uv[2], glm::vec2(100 / max, 7 / max));
    }
}

template <typename T>
class IndexTest : public testing::Test {};
using IndexTypes = testing::Types<std::uint8_t, std::uint16_t, std::uint32_t>;
TYPED_TEST_SUITE(IndexTest, IndexTypes);

TYPED_TEST(IndexTest, EveryWidth) {
    Builder b;
    Json& primitive = b.triangle();
    primitive["attributes"]["NORMAL"] = b.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});  // else vertices are put in order
    primitive["indices"] = b.accessor<TypeParam>({2, 0, 1}, "SCALAR", 1);
    EXPECT_EQ(b.importPrimitive().triangles.at(0), glm::uvec3(2, 0, 1));
}

TEST(Accessor, QuantisedPositions) {
    Builder b;
    b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    b.primitive({{"POSITION", b.accessor<std::int16_t>({0, 0, 0, 300, 0, 0, 0, -300, 0}, "VEC3", 3)},
                 {"NORMAL", b.accessor<std::int8_t>({0, 0, -127, 0, 0, -127, 0, 0, -127}, "VEC3", 3, true)}});
    const Primitive p = b.importPrimitive();
    EXPECT_EQ(p.positions.at(2), glm::vec3(0, -300, 0));
    EXPECT_EQ(p.normals.at(0), glm::vec3(0, 0, -1));
}

TEST(Accessor, InterleavedAttributesShareAView) {
    Builder b;
    // position, uv; 20 bytes a vertex
    const std::vector<float> data = {0, 0, 0, .1F, .2F, 1, 0, 0, .3F, .4F, 0, 1, 0, .5F, .6F};
    const int view = b.view(data, 20);
    const int position =
        b.push("accessors", {{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    const int uv =
        b.push("accessors",
               {{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}});
    b.primitive({{"POSITION", position}, {"TEXCOORD_0", uv}});
    const Primitive p = b.importPrimitive();
    EXPECT_EQ(p.positions.at(2), glm::vec3(0, 1, 0));
    EXPECT_EQ(p.uv0.at(1), glm::vec2(.3F, .4F));
}

TEST(Accessor, AnyStrideIsRead) {
    Builder b;
    std::vector<std::int16_t> packed = {0, 0, 0, 300, 0, 0, 0, -300, 0};
    b.primitive({{"POSITION", b.accessor(packed, "VEC3", 3)}});
    b.json["bufferViews"][0]["byteStride"] = 6;
    EXPECT_EQ(b.importPrimitive().positions.at(2), glm::vec3(0, -300, 0));
}

TEST(Accessor, UnalignedOffsetsAreRead) {
    Builder b;
    std::vector<std::uint8_t> bytes(37);
    const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::memcpy(bytes.data() + 1, positions, sizeof positions);
    b.primitive({{"POSITION", b.push("accessors", {{"bufferView", b.view(bytes)},
                                                   {"byteOffset", 1},
                                                   {"componentType", 5126},
                                                   {"count", 3},
                                                   {"type", "VEC3"}})}});
    EXPECT_EQ(b.importPrimitive().positions.at(1), glm::vec3(1, 0, 0));
}

Json sparse(Builder& b, const std::vector<std::uint16_t>& at, const std::vector<float>& values) {
    return {{"count", at.size()},
            {"indices", {{"bufferView", b.view(at)}, {"componentType", 5123}}},
            {"values", {{"bufferView", b.view(values)}}}};
}

TEST(Accessor, SparseReplacesElements) {
    Builder b;
    b.triangle();
    b.json["accessors"][0]["sparse"] = sparse(b, {1, 2}, {5, 0, 0, 0, 6, 0});
    const Primitive p = b.importPrimitive();
    EXPECT_EQ(p.positions.at(0), glm::vec3(0));
    EXPECT_EQ(p.positions.at(1), glm::vec3(5, 0, 0));
    EXPECT_EQ(p.positions.at(2), glm::vec3(0, 6, 0));
}

TEST(Accessor, SparseWithoutViewStartsFromZeros) {
    Builder b;
    b.triangle();
    b.json["accessors"][0].erase("bufferView");
    b.json["accessors"][0]["sparse"] = sparse(b, {0, 2}, {5, 0, 0, 0, 6, 0});
    const Primitive p = b.importPrimitive();
    EXPECT_EQ(p.positions.at(0), glm::vec3(5, 0, 0));
    EXPECT_EQ(p.positions.at(1), glm::vec3(0));
    EXPECT_EQ(p.positions.at(2), glm::vec3(0, 6, 0));
}

TEST(Accessor, SparseIndicesWithoutView) {
    Builder b;
    const int values = b.view(std::vector<std::uint8_t>{1, 2});
    const int at = b.view(std::vector<std::uint8_t>{1, 2});
    b.triangle()["indices"] = b.push("accessors", {{"componentType", 5121},
                                                   {"count", 3},
                                                   {"type", "SCALAR"},
                                                   {"sparse",
                                                    {{"count", 2},
                                                     {"indices", {{"bufferView", at}, {"componentType", 5121}}},
                                                     {"values", {{"bufferView", values}}}}}});
    EXPECT_EQ(b.importPrimitive().triangles.at(0), glm::uvec3(0, 1, 2));
}

TEST(Accessor, SparseFaults) {
    const auto fault = [](const std::vector<std::uint16_t>& at) {
        Builder b;
        b.triangle();
        b.json["accessors"][0]["sparse"] = sparse(b, at, std::vector<float>(at.size() * 3));
        return faultOf(b);
    };
    EXPECT_THAT(fault({3}), HasSubstr("accessors[0].sparse.indices: 3 is past its 3 elements"));
    EXPECT_THAT(fault({1, 1}), HasSubstr("accessors[0].sparse.indices: must rise, but 1 follows 1"));
    EXPECT_THAT(fault({0, 1, 2, 3}), HasSubstr("accessors[0].sparse.count: 4 is more than the accessor's 3"));
}

TEST(Accessor, SparseCountMustBeBackedByBytes) {
    Builder b;
    b.triangle();
    b.json["accessors"][0]["sparse"] = sparse(b, {0, 1}, {1, 2, 3});
    EXPECT_THAT(faultOf(b),
                HasSubstr("accessors[0].sparse.values: needs 24 bytes at offset 0, but bufferViews[2] holds 12"));
}

TEST(Accessor, MustFitItsView) {
    const auto fault = [](const Json& patch) {
        Builder b;
        b.triangle();
        b.json["accessors"][0].merge_patch(patch);
        return faultOf(b);
    };
    EXPECT_THAT(fault({{"count", 4}}),
                HasSubstr("scene.gltf: accessors[0]: needs 48 bytes at offset 0, but bufferViews[0] holds 36"));
    EXPECT_THAT(fault({{"byteOffset", 4}}), HasSubstr("needs 36 bytes at offset 4"));
    EXPECT_THAT(fault({{"byteOffset", 9007199254740000ULL}}), HasSubstr("bufferViews[0] holds 36"));
    EXPECT_THAT(fault({{"count", 9007199254740000ULL}}), HasSubstr("bufferViews[0] holds 36"));
    EXPECT_THAT(fault({{"count", 4000000000U}, {"bufferView", nullptr}}), HasSubstr("without a bufferView"));
    EXPECT_THAT(fault({{"componentType", 5124}}), HasSubstr("accessors[0].componentType: is none of glTF 2.0's"));
    EXPECT_THAT(fault({{"componentType", 5125}}), HasSubstr("32-bit integers"));
    EXPECT_THAT(fault({{"type", "MAT3"}}), HasSubstr("accessors[0].type: MAT3"));
    EXPECT_THAT(fault({{"type", "VEC2"}}), HasSubstr("has 2 components, not 3"));
}

TEST(Accessor, ViewMustFitItsBuffer) {
    Builder b;
    b.triangle();
    b.json["bufferViews"][0]["byteOffset"] = 8;
    EXPECT_THAT(faultOf(b), HasSubstr("bufferViews[0]: needs 36 bytes at offset 8, but buffers[0] holds 36"));
}

TEST(Accessor, StrideMustHoldAnElement) {
    Builder b;
    b.triangle();
    b.json["bufferViews"][0]["byteStride"] = 4;
    EXPECT_THAT(faultOf(b), HasSubstr("bufferViews[0].byteStride: 4 is less than the 12 bytes"));
}

TEST(Accessor, OnlyTheRangeInUseIsRead) {
    Builder b;
    // Two triangles share an accessor; the first three vertices are not finite and belong to neither.
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const int position = b.vec3({nan, 0, 0, nan, 0, 0, nan, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    b.primitive({{"POSITION", position}})["indices"] = b.accessor<std::uint8_t>({3, 4, 5}, "SCALAR", 1);
    b.json["accessors"][0]["sparse"] = sparse(b, {0, 4}, {9, 9, 9, 7, 0, 0});
    b.json["accessors"][0]["name"] = "positions";
    const Primitive p = b.importPrimitive();
    EXPECT_EQ(p.positions.size(), 3U);
    EXPECT_EQ(p.triangles.at(0), glm::uvec3(0, 1, 2));
    EXPECT_EQ(p.positions.at(1), glm::vec3(7, 0, 0));
}

}  // namespace
}  // namespace vkpt::test
