#include "scene/camera.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

RenderParams window(std::uint32_t width, std::uint32_t height) {
    RenderParams params{};
    params.width = width;
    params.height = height;
    return params;
}

/// Where a point appears: x right and y up in [-1,1] inside the window, z its depth.
glm::vec3 project(const RenderParams& p, const glm::vec3& point) {
    const glm::vec3 d = point - p.eye;
    const float depth = glm::dot(d, p.forward), w = p.projection == kProjectionPerspective ? depth : 1.0F;
    return {glm::dot(d, p.right) / glm::dot(p.right, p.right) / w, glm::dot(d, p.up) / glm::dot(p.up, p.up) / w, depth};
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5F) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Camera, LookAtHasVerticalFieldOfView) {
    RenderParams p = window(200, 100);
    lookAt(p, {0, 0, 5}, {0, 0, 0}, 90);
    expectNear(p.forward, {0, 0, -1});
    expectNear(p.up, {0, 1, 0});
    expectNear(p.right, {2, 0, 0});
    EXPECT_EQ(p.projection, kProjectionPerspective);
}

TEST(Camera, LookingStraightDownPutsMinusZUp) {
    RenderParams p = window(100, 100);
    lookAt(p, {0, 3, 0}, {0, 0, 0}, 90);
    expectNear(p.up, {0, 0, -1});
    expectNear(p.right, {1, 0, 0});
}

TEST(Camera, OrbitStandsWhereDesignSays) {
    RenderParams p = window(100, 100);
    orbit(p, 90, 90, 2, {1, 1, 1}, 90);  // theta 90: on +x
    expectNear(p.eye, {3, 1, 1});
    expectNear(p.forward, {-1, 0, 0});
    expectNear(p.up, {0, 1, 0});
    expectNear(p.right, {0, 0, -1});
    orbit(p, 0, 0, 2, {0, 0, 0}, 90);  // the pole
    expectNear(p.eye, {0, 2, 0});
    expectNear(p.up, {0, 0, -1});
    orbit(p, 30, 70, 0, {1, 2, 3}, 90);
    expectNear(p.eye, {1, 2, 3});
}

// What fills the window at the distance fills it in either projection.
TEST(Camera, ProjectionsShowTheSameAtTheirDistance) {
    RenderParams p = window(200, 100);
    lookAt(p, {1, 2, 5}, {1, 2, 0}, 40);
    const RenderParams perspective = p;
    const glm::vec3 corner = p.eye + 5.0F * (p.forward + p.right + p.up);
    setProjection(p, kProjectionOrthographic, 5);
    EXPECT_EQ(p.projection, kProjectionOrthographic);
    expectNear(project(p, corner), {1, 1, 5});
    expectNear(project(perspective, corner), {1, 1, 5});
    setProjection(p, kProjectionPerspective, 5);
    expectNear(p.right, perspective.right);
    expectNear(p.up, perspective.up);
    setProjection(p, kProjectionPerspective, 9);  // is one already
    expectNear(p.up, perspective.up);
}

TEST(Camera, PanoramaKeepsTheAxes) {
    for (const std::uint32_t before : {kProjectionPerspective, kProjectionOrthographic}) {
        RenderParams p = window(200, 100);
        lookAt(p, {0, 0, 5}, {0, 0, 0}, 40);
        setProjection(p, before, 3);
        setProjection(p, kProjectionPanorama, 3);
        EXPECT_EQ(p.projection, kProjectionPanorama);
        expectNear(p.forward, {0, 0, -1});
        expectNear(p.right, {1, 0, 0});
        expectNear(p.up, {0, 1, 0});
    }
}

TEST(Camera, HalfHeightKeepsTheAspectRatio) {
    RenderParams p = window(200, 100);
    lookAt(p, {0, 0, 5}, {0, 0, 0}, 40);
    setProjection(p, kProjectionOrthographic, 5);
    setHalfHeight(p, 3);
    expectNear(p.up, {0, 3, 0});
    expectNear(p.right, {6, 0, 0});
}

TEST(Camera, OrbitAndLookAtAgree) {
    RenderParams a = window(160, 90), b = a;
    orbit(a, 30, 75, 3, {0.5F, 1, 0}, 40);
    lookAt(b, a.eye, {0.5F, 1, 0}, 40);
    expectNear(a.right, b.right);
    expectNear(a.up, b.up);
    expectNear(a.forward, b.forward);
}

TEST(Camera, ImpossibleViewsAreUsageErrors) {
    RenderParams p = window(100, 100);
    EXPECT_THROW(lookAt(p, {1, 1, 1}, {1, 1, 1}), Error);
    EXPECT_THROW(lookAt(p, {1, 1, 1}, {0, 0, 0}, 180), Error);
    EXPECT_THROW(orbit(p, 0, 0, -1, {0, 0, 0}), Error);
}

TEST(Camera, FramingShowsEverythingAndFillsTheWindow) {
    for (const auto& [width, height] : {std::pair{960U, 540U}, std::pair{100U, 100U}, std::pair{90U, 200U}}) {
        for (const glm::vec3& scale : {glm::vec3(1), glm::vec3(20, 0.1F, 1), glm::vec3(1e-4F), glm::vec3(1, 300, 1)}) {
            const glm::mat4 place = glm::translate(glm::mat4(1), {7, -2, 3}) * glm::scale(glm::mat4(1), scale) *
                                    glm::rotate(glm::mat4(1), 0.7F, glm::vec3(1, 1, 0));
            const SceneArrays arrays = flatten(sceneOf(gridPrimitive(3), {place}));
            RenderParams p = window(width, height);
            frameScene(p, arrays);
            float most = 0;
            for (const TriangleRecord& t : arrays.triangles) {
                for (const glm::vec3& v : {t.v0, t.v1, t.v2}) {
                    const glm::vec3 q = project(p, v);
                    EXPECT_GT(q.z, 0);
                    most = std::max({most, std::abs(q.x), std::abs(q.y)});
                }
            }
            EXPECT_LT(most, 0.95F);
            EXPECT_GT(most, 0.85F);
            EXPECT_GT(p.eye.z, 0);
        }
    }
}

TEST(Camera, FramingAnEmptySceneIsFinite) {
    RenderParams p = window(100, 50);
    frameScene(p, flatten(Scene{}));
    EXPECT_GT(project(p, {0, 0, 0}).z, 0);
}

TEST(Camera, FileCameraKeepsItsVerticalSize) {
    Scene scene;
    Camera camera;
    camera.yfov = glm::radians(90.0F);
    camera.aspect = 5;
    camera.worldFromCamera = glm::translate(glm::mat4(1), {1, 2, 3}) * glm::scale(glm::mat4(1), glm::vec3(4));
    RenderParams p = window(300, 100);
    fromCamera(p, scene, camera);
    expectNear(p.eye, {1, 2, 3});
    expectNear(p.right, {3, 0, 0});
    expectNear(p.up, {0, 1, 0});
    expectNear(p.forward, {0, 0, -1});

    camera.orthographic = true;
    camera.ymag = 2.5F;
    fromCamera(p, scene, camera);
    EXPECT_EQ(p.projection, kProjectionOrthographic);
    expectNear(p.right, {7.5F, 0, 0});
    expectNear(p.up, {0, 2.5F, 0});

    camera.worldFromCamera = glm::mat4(0);
    EXPECT_THROW(fromCamera(p, scene, camera), FileError);
}

TEST(Camera, FoundByNameThenByIndex) {
    Scene scene;
    scene.cameras.resize(3);
    scene.cameras[0].name = "2";
    scene.cameras[1].name = "front";
    EXPECT_EQ(&findCamera(scene, "front"), &scene.cameras[1]);
    EXPECT_EQ(&findCamera(scene, "2"), &scene.cameras[0]);
    EXPECT_EQ(&findCamera(scene, "1"), &scene.cameras[1]);
    EXPECT_THROW((void)findCamera(scene, "3"), FileError);
    EXPECT_THROW((void)findCamera(scene, ""), FileError);
    EXPECT_THROW((void)findCamera(Scene{}, "0"), FileError);
}

}  // namespace
}  // namespace vkpt
