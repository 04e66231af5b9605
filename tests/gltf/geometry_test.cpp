// Primitive modes, attributes, normals and the faults they may have.
#include <limits>

#include "builder.h"

namespace vkpt::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

// n vertices on a parabola with normals, drawn in `mode`.
Builder curve(int n, int mode) {
    Builder b;
    std::vector<float> positions, normals;
    for (int i = 0; i < n; ++i) {
        const auto x = static_cast<float>(i);
        positions.insert(positions.end(), {x, x * x, 0});
        normals.insert(normals.end(), {0, 0, 1});
    }
    b.primitive({{"POSITION", b.vec3(positions)}, {"NORMAL", b.vec3(normals)}})["mode"] = mode;
    return b;
}

TEST(Geometry, StripsAlternateTheirWinding) {
    EXPECT_THAT(curve(5, 5).importPrimitive().triangles,
                ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(1, 3, 2), glm::uvec3(2, 3, 4)));
}

TEST(Geometry, FansTurnAroundTheFirstVertex) {
    EXPECT_THAT(curve(5, 6).importPrimitive().triangles,
                ElementsAre(glm::uvec3(1, 2, 0), glm::uvec3(2, 3, 0), glm::uvec3(3, 4, 0)));
}

TEST(Geometry, NonIndexedTriangles) {
    EXPECT_THAT(curve(6, 4).importPrimitive().triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(3, 4, 5)));
}

// The last triangle begins at an odd place, so it is wound the other way.
TEST(Geometry, IndexedStripSkipsTrianglesThatTurnCorners) {
    Builder b = curve(6, 5);
    b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor<std::uint8_t>({0, 1, 2, 2, 3, 3, 4, 5}, "SCALAR", 1);
    EXPECT_THAT(b.importPrimitive().triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(3, 5, 4)));
}

TEST(Geometry, SpareVerticesMakeAWarning) {
    const Scene scene = curve(5, 4).import();
    EXPECT_EQ(scene.meshes[0].primitives.at(0).triangles.size(), 1U);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("meshes[0].primitives[0]: 5 vertices")));
}

TEST(Geometry, CountsPointsAndLines) {
    const auto skipped = [](int n, int mode) {
        const Scene scene = curve(n, mode).import();
        EXPECT_TRUE(scene.meshes.at(0).primitives.empty());
        EXPECT_EQ(scene.warnings.size(), 1U);
        return std::pair(scene.skippedPoints, scene.skippedLines);
    };
    EXPECT_EQ(skipped(7, 0), std::pair(7UL, 0UL));
    EXPECT_EQ(skipped(7, 1), std::pair(0UL, 3UL));
    EXPECT_EQ(skipped(7, 2), std::pair(0UL, 7UL));
    EXPECT_EQ(skipped(7, 3), std::pair(0UL, 6UL));
}

TEST(Geometry, MissingNormalsAreFlatAndVerticesUnshared) {
    Builder b;
    // Two triangles folded at a right angle along the edge 0-1, with vertex colours to follow.
    Json& p = b.primitive({{"POSITION", b.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})},
                           {"COLOR_0", b.vec3({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1})},
                           {"TANGENT", b.vec4(std::vector<float>(16, 1))}});
    p["indices"] = b.accessor<std::uint16_t>({0, 1, 2, 1, 0, 3}, "SCALAR", 1);
    const Primitive out = b.importPrimitive();
    EXPECT_THAT(out.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(3, 4, 5)));
    EXPECT_EQ(out.normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(out.normals.at(4), glm::vec3(0, 1, 0));
    EXPECT_EQ(out.positions.at(5), glm::vec3(0, 0, 1));
    EXPECT_EQ(out.colors.at(3), glm::vec4(0, 1, 0, 1));
    EXPECT_TRUE(out.tangents.empty());
}

TEST(Geometry, DegenerateTrianglesStillGetUnitNormals) {
    Builder b;
    b.primitive({{"POSITION", b.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0})}});
    EXPECT_FLOAT_EQ(glm::length(b.importPrimitive().normals.at(0)), 1);
}

TEST(Geometry, NormalsAreScaledToUnitLength) {
    Builder b;
    b.triangle()["attributes"]["NORMAL"] = b.vec3({0, 3, 0, 0, 0, .5F, -1, 0, 0});
    EXPECT_THAT(b.importPrimitive().normals, ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0)));
}

TEST(Geometry, ValuesThatAreNoNumbersOrDirectionsAreFaults) {
    const auto fault = [](const char* name, auto&& values) {
        Builder b;
        Json& p = b.triangle();
        p["attributes"][name] = values(b);
        return faultOf(b);
    };
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_THAT(fault("POSITION",
                          [&](Builder& b) {
                              return b.vec3({0, 0, 0, 1, bad, 0, 0, 1, 0});
                          }),
                    HasSubstr("meshes[0].primitives[0].attributes.POSITION: accessors[1][1] is not finite"));
        EXPECT_THAT(fault("NORMAL",
                          [&](Builder& b) {
                              return b.vec3({0, 0, 1, 0, 0, 1, 0, 0, bad});
                          }),
                    HasSubstr("attributes.NORMAL: accessors[1][2] is not finite"));
        EXPECT_THAT(fault("TEXCOORD_1",
                          [&](Builder& b) {
                              return b.vec2({0, 0, bad, 1, 1, 1});
                          }),
                    HasSubstr("attributes.TEXCOORD_1: accessors[1][1] is not finite"));
        EXPECT_THAT(fault("COLOR_0",
                          [&](Builder& b) {
                              return b.vec3({0, 0, bad, 1, 0, 0, 0, 1, 0});
                          }),
                    HasSubstr("attributes.COLOR_0: accessors[1][0] is not finite"));
    }
    EXPECT_THAT(fault("NORMAL",
                      [&](Builder& b) {
                          return b.vec3({0, 0, 1, 0, 0, 0, 0, 0, 1});
                      }),
                HasSubstr("attributes.NORMAL: accessors[1][1] has no direction"));
}

TEST(Geometry, ColoursOfEveryType) {
    const auto color = [](auto values, const char* type, std::size_t components, bool normalized) {
        Builder b;
        Json& primitive = b.triangle();
        primitive["attributes"]["COLOR_0"] = b.accessor(values, type, components, normalized);
        return b.importPrimitive().colors.at(1);
    };
    EXPECT_EQ(color(std::vector<float>{0, 0, 0, .25F, .5F, .75F, 0, 0, 0}, "VEC3", 3, false),
              glm::vec4(.25F, .5F, .75F, 1));
    EXPECT_EQ(color(std::vector<float>{0, 0, 0, 0, 2, -1, 0, .5F, 0, 0, 0, 0}, "VEC4", 4, false),
              glm::vec4(1, 0, 0, .5F));
    const std::vector<std::uint8_t> bytes = {0, 0, 0, 0, 255, 0, 51, 255, 0, 0, 0, 0};
    EXPECT_EQ(color(bytes, "VEC4", 4, true), glm::vec4(1, 0, .2F, 1));
    EXPECT_EQ(color(bytes, "VEC4", 4, false), glm::vec4(1, 0, .2F, 1)) << "integers are colours in [0,1] all the same";
    const std::vector<std::uint16_t> words = {0, 0, 0, 65535, 13107, 0, 0, 0, 0};
    EXPECT_EQ(color(words, "VEC3", 3, true), glm::vec4(1, .2F, 0, 1));
}

TEST(Geometry, TwoSetsOfTextureCoordinates) {
    Builder b;
    Json& p = b.triangle();
    p["attributes"]["TEXCOORD_0"] = b.vec2({0, 1, 2, 3, 4, 5});
    p["attributes"]["TEXCOORD_1"] = b.vec2({9, 8, 7, 6, 5, 4});
    const Primitive out = b.importPrimitive();
    EXPECT_EQ(out.uv0.at(1), glm::vec2(2, 3));
    EXPECT_EQ(out.uv1.at(1), glm::vec2(7, 6));
}

TEST(Geometry, Faults) {
    const auto fault = [](auto&& edit) {
        Builder b;
        edit(b, b.triangle());
        return faultOf(b);
    };
    EXPECT_THAT(fault([](Builder& b, Json& p) {
                    p["indices"] = b.accessor<std::uint8_t>({0, 1, 3}, "SCALAR", 1);
                }),
                HasSubstr("meshes[0].primitives[0].indices: accessors[1][2] is 3, but there are 3 vertices"));
    EXPECT_THAT(fault([](Builder& b, Json& p) {
                    p["indices"] = b.accessor<float>({0, 1, 2}, "SCALAR", 1);
                }),
                HasSubstr("accessors[1]: indices must be unsigned scalars"));
    EXPECT_THAT(fault([](Builder& b, Json& p) {
                    p["attributes"]["NORMAL"] = b.vec3({0, 0, 1});
                }),
                HasSubstr("attributes.NORMAL: has 1 elements, but POSITION has 3"));
    EXPECT_THAT(fault([](Builder& b, Json& p) {
                    p["attributes"]["POSITION"] = b.vec3({0, 0, 1, 0, kNan, 0, 1, 1, 1});
                }),
                HasSubstr("attributes.POSITION: accessors[1][1] is not finite"));
    EXPECT_THAT(fault([](Builder& b, Json& p) {
                    p["attributes"]["COLOR_0"] = b.vec2({0, 0, 0, 0, 0, 0});
                }),
                HasSubstr("attributes.COLOR_0: accessors[1] has 2 components"));
    EXPECT_THAT(fault([](Builder&, Json& p) { p["mode"] = 7; }), HasSubstr("mode: 7"));
}

// Many primitives may share an accessor, but what they make of it must stay in proportion to the file.
TEST(Geometry, DrawingTheSameAccessorWithoutEndIsRefused) {
    Builder b;
    b.primitive({{"POSITION", b.accessor<std::int8_t>(std::vector<std::int8_t>(3 * 3000, 1), "VEC3", 3)}});
    Json& primitives = b.json["meshes"][0]["primitives"];
    const Json one = primitives[0];
    for (int i = 1; i < 90; ++i) primitives.push_back(one);
    EXPECT_EQ(b.import().meshes.at(0).primitives.size(), 90U);
    for (int i = 90; i < 110; ++i) primitives.push_back(one);
    EXPECT_THAT(faultOf(b), HasSubstr("meshes: their primitives draw more than 64 elements"));
}

TEST(Geometry, PrimitiveWithoutPositionsIsSkipped) {
    Builder b;
    b.triangle();
    b.json["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
    const Scene scene = b.import();
    EXPECT_EQ(scene.meshes[0].primitives.size(), 1U);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("meshes[0].primitives[1]: has no POSITION")));
}

}  // namespace
}  // namespace vkpt::test
