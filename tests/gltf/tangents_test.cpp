// Tangents in MikkTSpace's sense.
#include "gltf/tangents.h"

#include <cmath>

#include "builder.h"

namespace vkpt::test {
namespace {

using gltf::makeTangents;

constexpr float kPiF = 3.14159265F;

// A unit square in the xy plane: its image upright unless `mirrored`, when U runs the other way.
void addQuad(Primitive& p, const glm::vec3& origin, bool mirrored) {
    const auto first = static_cast<std::uint32_t>(p.positions.size());
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        p.positions.push_back(origin + glm::vec3(corner, 0));
        p.normals.emplace_back(0, 0, 1);
        p.uv0.emplace_back(mirrored ? 1 - corner.x : corner.x, 1 - corner.y);
    }
    p.triangles.emplace_back(first, first + 1, first + 2);
    p.triangles.emplace_back(first, first + 2, first + 3);
}

glm::vec3 bitangent(const Primitive& p, std::size_t i) {
    return glm::cross(p.normals[i], glm::vec3(p.tangents[i])) * p.tangents[i].w;
}

TEST(Tangents, FollowUAndBitangentPointsUpInTheImage) {
    Primitive p;
    addQuad(p, {}, false);
    makeTangents(p, 0);
    ASSERT_EQ(p.tangents.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(p.tangents[i], glm::vec4(1, 0, 0, 1));
        expectNear(bitangent(p, i), {0, 1, 0});
    }
}

TEST(Tangents, MirroredImageFlipsTheHandednessOnly) {
    Primitive p;
    addQuad(p, {}, true);
    makeTangents(p, 0);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(p.tangents[i], glm::vec4(-1, 0, 0, -1));
        expectNear(bitangent(p, i), {0, 1, 0});
    }
}

// Vertices on the seam of a mirrored image serve both sides in the file; each side needs its own.
TEST(Tangents, MirrorSeamSplitsItsVertices) {
    Primitive p;
    for (const float x : {-1.F, 0.F, 1.F})
        for (const float y : {0.F, 1.F}) {
            p.positions.emplace_back(x, y, 0);
            p.normals.emplace_back(0, 0, 1);
            p.uv0.emplace_back(std::abs(x), 1 - y);
        }
    p.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
    makeTangents(p, 0);
    EXPECT_EQ(p.positions.size(), 8U);
    EXPECT_EQ(p.normals.size(), 8U);
    EXPECT_EQ(p.uv0.size(), 8U);
    EXPECT_EQ(p.tangents.size(), 8U);
    for (std::size_t t = 0; t < 4; ++t)
        for (glm::length_t c = 0; c < 3; ++c)
            EXPECT_EQ(p.tangents[p.triangles[t][c]], t < 2 ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1));
}

// Fold two squares along x = 0: vertices that differ only in their index count as one and average.
Primitive foldedSheet(float uScaleLeft) {
    Primitive p;
    const glm::vec3 n = glm::normalize(glm::vec3(0, 0, 1));
    const auto add = [&](glm::vec3 position, float u, float v) {
        p.positions.push_back(position);
        p.normals.push_back(n);
        p.uv0.emplace_back(u, v);
    };
    add({-1, 0, -1}, 1 - uScaleLeft, 1);
    add({0, 0, 0}, 1, 1);
    add({0, 1, 0}, 1, 0);
    add({0, 0, 0}, 1, 1);
    add({1, 1, 0}, 2, 0);
    add({0, 1, 0}, 1, 0);
    p.triangles = {{0, 1, 2}, {3, 4, 5}};
    return p;
}

TEST(Tangents, EqualVerticesCountAsOne) {
    Primitive p = foldedSheet(1);
    makeTangents(p, 0);
    EXPECT_EQ(p.positions.size(), 6U);
    EXPECT_EQ(p.tangents[1], p.tangents[3]);
    EXPECT_EQ(p.tangents[2], p.tangents[5]);
}

TEST(Tangents, DifferentNormalsKeepApart) {
    Primitive p = foldedSheet(1);
    for (std::size_t i = 0; i < 3; ++i) p.normals[i] = glm::normalize(glm::vec3(-1, 0, 1));
    makeTangents(p, 0);
    expectNear(glm::vec3(p.tangents[1]), glm::normalize(glm::vec3(1, 0, 1)));
    expectNear(glm::vec3(p.tangents[3]), {1, 0, 0});
}

// Two triangles around a shared edge, in one plane, whose images are turned against each other: the vertices get the
// mean of both directions, weighted by the corners' angles. Worked out by hand.
TEST(Tangents, AverageIsWeightedByAngle) {
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
    p.normals.assign(4, {0, 0, 1});
    // Triangle 0 1 2 has U along x. In triangle 0 2 3 U grows along (1, a) for the a that fits the shared edge.
    p.uv0 = {{0, 0}, {1, 0}, {1, -1}, {-1, -2}};
    p.triangles = {{0, 1, 2}, {0, 2, 3}};
    makeTangents(p, 0);
    // dP/du of 0 2 3: u = A x + B y with A + B = 1, -A + B = -1 -> u = x; v = C x + D y with C + D = -1, -C + D = -2:
    // C = 0.5, D = -1.5. dP/du solves u = 1, v = 0: (1, 1/3).
    const glm::vec3 a(1, 0, 0), b = glm::normalize(glm::vec3(3, 1, 0));
    const float angleA = kPiF / 4, angleB = kPiF / 2;
    expectNear(glm::vec3(p.tangents[0]), glm::normalize(a * angleA + b * angleB), 1e-5F);
    expectNear(glm::vec3(p.tangents[1]), a, 1e-5F);
    expectNear(glm::vec3(p.tangents[3]), b, 1e-5F);
}

// On a finely cut sphere the tangents are the parallels of latitude, and the seam does not show.
TEST(Tangents, SphereHasItsParallels) {
    constexpr int kAround = 48, kDown = 24;
    Primitive p;
    for (int j = 0; j <= kDown; ++j)
        for (int i = 0; i <= kAround; ++i) {
            const float u = static_cast<float>(i) / kAround, v = static_cast<float>(j) / kDown;
            const float phi = 2 * kPiF * u, theta = kPiF * v;
            const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
            p.positions.push_back(n);
            p.normals.push_back(n);
            p.uv0.emplace_back(u, v);
        }
    for (std::uint32_t j = 0; j < kDown; ++j)
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const std::uint32_t a = j * (kAround + 1) + i, b = a + kAround + 1;
            p.triangles.emplace_back(a, b, b + 1);
            p.triangles.emplace_back(a, b + 1, a + 1);
        }
    makeTangents(p, 0);
    for (std::size_t i = 0; i < p.positions.size(); ++i) {
        const glm::vec3& n = p.normals[i];
        EXPECT_NEAR(glm::length(glm::vec3(p.tangents[i])), 1, 1e-5);
        EXPECT_NEAR(glm::dot(n, glm::vec3(p.tangents[i])), 0, 1e-5);
        if (std::abs(n.y) > 0.95F) continue;  // at the poles the image has no direction
        EXPECT_EQ(p.tangents[i].w, 1);
        const float phi = 2 * kPiF * p.uv0[i].x;
        expectNear(glm::vec3(p.tangents[i]), {-std::sin(phi), 0, -std::cos(phi)},
                   0.07F);  // vertices of the seam see one side only: half a step
    }
}

TEST(Tangents, WithoutImageAnyDirectionAcrossTheNormalServes) {
    Primitive p;
    addQuad(p, {}, false);
    p.uv0.clear();
    makeTangents(p, 0);
    ASSERT_EQ(p.tangents.size(), 4U);
    for (const glm::vec4& t : p.tangents) EXPECT_NEAR(glm::length(glm::vec3(t)), 1, 1e-5);
    for (const glm::vec4& t : p.tangents) EXPECT_NEAR(t.z, 0, 1e-6);
}

// A triangle whose image is a line takes the tangents around it instead of spoiling them.
TEST(Tangents, TriangleWithoutGradientJoinsItsNeighbour) {
    Primitive p;
    addQuad(p, {}, true);
    p.positions.emplace_back(2, 0.5F, 0);
    p.normals.emplace_back(0, 0, 1);
    p.uv0.emplace_back(0, 0.5F);  // on the edge's own line in the image
    p.triangles.emplace_back(1, 4, 2);
    makeTangents(p, 0);
    EXPECT_EQ(p.tangents[1], glm::vec4(-1, 0, 0, -1));
    EXPECT_EQ(p.tangents[2], glm::vec4(-1, 0, 0, -1));
    EXPECT_EQ(p.positions.size(), 5U) << "no vertex had to be split";
}

TEST(Tangents, ThousandsOfTrianglesAroundOneVertex) {
    constexpr std::uint32_t kCount = 20000;
    Primitive p;
    p.positions = {{0, 0, 0}};
    p.uv0 = {{0, 0}};
    for (std::uint32_t i = 0; i <= kCount; ++i) {
        const float a = 2 * kPiF * static_cast<float>(i) / kCount;
        p.positions.emplace_back(std::cos(a), std::sin(a), 0);
        p.uv0.emplace_back(std::cos(a), -std::sin(a));
        if (i > 0) p.triangles.emplace_back(0, i, i + 1);
    }
    p.normals.assign(p.positions.size(), {0, 0, 1});
    makeTangents(p, 0);
    expectNear(glm::vec3(p.tangents[0]), {1, 0, 0}, 1e-3F);
}

// Through a file: made only where a normal map needs them, from its own set of texture coordinates.
TEST(Tangents, ImportUsesTheNormalMapsTexCoord) {
    Builder b;
    Json& p = b.triangle();
    p["attributes"]["NORMAL"] = b.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    p["attributes"]["TEXCOORD_0"] = b.vec2({0, 1, 1, 1, 0, 0});
    p["attributes"]["TEXCOORD_1"] = b.vec2({0, 0, 0, 1, 1, 0});
    EXPECT_TRUE(b.importPrimitive().tangents.empty());
    // A grey pixel.
    b.textured({{"uri",
                 "data:image/png;base64,"
                 "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg=="}});
    b.json["materials"][0] = {{"normalTexture", {{"index", 0}, {"texCoord", 1}}}};
    const Primitive out = b.importPrimitive();
    ASSERT_EQ(out.tangents.size(), 3U);
    expectNear(glm::vec3(out.tangents[0]), {0, 1, 0});
}

TEST(Tangents, ImportKeepsGoodOnesAndRefusesBadOnes) {
    const auto builder = [](const std::vector<float>& values) {
        Builder b;
        Json& p = b.triangle();
        p["attributes"]["NORMAL"] = b.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
        p["attributes"]["TEXCOORD_0"] = b.vec2({0, 1, 1, 1, 0, 0});
        p["attributes"]["TANGENT"] = b.vec4(values);
        b.textured({{"uri",
                     "data:image/png;base64,"
                     "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg=="}});
        b.json["materials"][0] = {{"normalTexture", {{"index", 0}}}};
        return b;
    };
    EXPECT_EQ(builder({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}).importPrimitive().tangents.at(2),
              glm::vec4(0, 1, 0, -1));
    Builder bad = builder({0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, -1});
    EXPECT_THAT(faultOf(bad), testing::HasSubstr("attributes.TANGENT: accessors[3][1] has no direction"));
    bad.json["materials"][0] = Json::object();
    EXPECT_TRUE(bad.importPrimitive().tangents.empty()) << "nothing reads them";
    EXPECT_THAT(faultOf(builder({0, 1, 0, -1, 0, 1, 0, 0, 0, 1, 0, 1})),
                testing::HasSubstr("accessors[3][1] has no handedness"));
}

}  // namespace
}  // namespace vkpt::test
