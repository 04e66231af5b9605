#include "scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/math.h"

namespace vkpt {
namespace {

constexpr float kFrameTheta = 35, kFramePhi = 72;  // degrees: the three-quarter view
constexpr float kFrameFill = 0.92F;                // share of the window the scene may fill

float aspect(const RenderParams& params) {
    return static_cast<float>(params.width) / static_cast<float>(params.height);
}

struct Axes {
    glm::vec3 right, up, forward;  // orthonormal
};

void setPerspective(RenderParams& params, const glm::vec3& eye, const Axes& axes, float tangent) {
    params.projection = kProjectionPerspective;
    params.eye = eye;
    params.forward = axes.forward;
    params.right = axes.right * (tangent * aspect(params));
    params.up = axes.up * tangent;
}

float fovTangent(float fov) {
    if (!(fov > 0 && fov < 180)) {
        throw Error(ExitCode::Usage, fmt::format("--fov {}: must lie between 0 and 180 degrees", fov));
    }
    return std::tan(glm::radians(fov) / 2);
}

Axes axesTowards(const glm::vec3& forward) {
    const bool vertical = std::hypot(forward.x, forward.z) < 1e-6F * std::abs(forward.y);
    const glm::vec3 f = glm::normalize(forward);
    const glm::vec3 right = glm::normalize(glm::cross(f, vertical ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0)));
    return {right, glm::cross(right, f), f};
}

Axes orbitAxes(float theta, float phi) {
    const float t = glm::radians(theta), p = glm::radians(phi);
    const glm::vec3 outward(std::sin(p) * std::sin(t), std::cos(p), std::sin(p) * std::cos(t));
    const glm::vec3 up(-std::cos(p) * std::sin(t), std::sin(p), -std::cos(p) * std::cos(t));
    return {glm::cross(up, outward), up, -outward};
}

/// Finds the nearest eye for which all points added lie in the window: for each pair of opposite planes of the frustum,
/// the extreme points of either plane fix where they cross.
class Framing {
public:
    Framing(const Axes& axes, float tangentX, float tangentY) : axes_(axes), tangent_(tangentX, tangentY) {}

    void add(const glm::vec3& p) {
        const glm::vec2 side(glm::dot(p, axes_.right), glm::dot(p, axes_.up));
        const float depth = glm::dot(p, axes_.forward);
        high_ = glm::max(high_, side - tangent_ * depth);
        low_ = glm::min(low_, side + tangent_ * depth);
        nearest_ = std::min(nearest_, depth);
    }

    [[nodiscard]] glm::vec3 eye() const {
        const glm::vec2 depths = (low_ - high_) / (2.0F * tangent_);
        const glm::vec2 side = (low_ + high_) / 2.0F;
        const float depth = std::min({depths.x, depths.y, nearest_});
        return axes_.right * side.x + axes_.up * side.y + axes_.forward * depth;
    }

private:
    Axes axes_;
    glm::vec2 tangent_;
    glm::vec2 high_{-std::numeric_limits<float>::infinity()}, low_{std::numeric_limits<float>::infinity()};
    float nearest_ = std::numeric_limits<float>::infinity();
};

void addTriangles(Framing& framing, const SceneArrays& arrays, const MeshRange& range) {
    for (std::uint32_t i = range.firstTriangle; i < range.firstTriangle + range.triangleCount; ++i) {
        const TriangleRecord& triangle = arrays.triangles[i];
        framing.add(triangle.v0);
        framing.add(triangle.v1);
        framing.add(triangle.v2);
    }
}

void addBox(Framing& framing, const glm::vec3& low, const glm::vec3& high) {
    for (int i = 0; i < 8; ++i) framing.add(glm::mix(low, high, glm::vec3(i & 1, i >> 1 & 1, i >> 2)));
}

}  // namespace

void lookAt(RenderParams& params, const glm::vec3& eye, const glm::vec3& target, float fov) {
    const float tangent = fovTangent(fov);
    if (!isFinite(target - eye) || !(glm::length(target - eye) > 0)) {
        throw Error(ExitCode::Usage, "--eye and --target are the same point: move one");
    }
    setPerspective(params, eye, axesTowards(target - eye), tangent);
}

void orbit(RenderParams& params, float theta, float phi, float radius, const glm::vec3& target, float fov) {
    const float tangent = fovTangent(fov);
    if (!(radius >= 0)) throw Error(ExitCode::Usage, fmt::format("--orbit: radius {} is negative", radius));
    const Axes axes = orbitAxes(theta, phi);
    setPerspective(params, target - axes.forward * radius, axes, tangent);
}

void frameScene(RenderParams& params, const SceneArrays& arrays, float fov) {
    const float tangent = fovTangent(fov);
    const Axes axes = orbitAxes(kFrameTheta, kFramePhi);
    Framing framing(axes, tangent * aspect(params) * kFrameFill, tangent * kFrameFill);
    if (arrays.triangles.empty()) {
        addBox(framing, glm::vec3(-1), glm::vec3(1));
    } else if (arrays.features.instances) {
        addBox(framing, arrays.boundsMin, arrays.boundsMax);
    } else {
        addTriangles(framing, arrays, arrays.meshRanges[0]);
    }
    setPerspective(params, framing.eye(), axes, tangent);
}

void fromCamera(RenderParams& params, const Scene& scene, const Camera& camera) {
    const glm::vec3 back(camera.worldFromCamera[2]), upwards(camera.worldFromCamera[1]);
    const glm::vec3 side = glm::cross(upwards, back);
    if (!isFinite(side) || !(glm::length(side) > 0)) {
        throw FileError(scene.path.string(),
                        "camera '" + camera.name + "': its node is scaled to nothing; give another");
    }
    // glTF: a scale of the node has no effect on the camera.
    const glm::vec3 forward = -glm::normalize(back), right = glm::normalize(side);
    const Axes axes{right, glm::cross(right, forward), forward};
    const glm::vec3 eye(camera.worldFromCamera[3]);
    setPerspective(params, eye, axes, camera.orthographic ? camera.ymag : std::tan(camera.yfov / 2));
    if (camera.orthographic) params.projection = kProjectionOrthographic;
}

void setProjection(RenderParams& params, std::uint32_t projection, float distance) {
    if (projection == params.projection) return;
    if (params.projection == kProjectionOrthographic) {
        params.right /= distance;
        params.up /= distance;
    }
    if (projection == kProjectionOrthographic) {
        params.right *= distance;
        params.up *= distance;
    } else if (projection == kProjectionPanorama) {
        params.right = glm::normalize(params.right);
        params.up = glm::normalize(params.up);
    }
    params.projection = projection;
}

void setHalfHeight(RenderParams& params, float halfHeight) {
    const float scale = halfHeight / glm::length(params.up);
    params.up *= scale;
    params.right *= scale;
}

const Camera& findCamera(const Scene& scene, std::string_view nameOrIndex) {
    for (const Camera& camera : scene.cameras) {
        if (!nameOrIndex.empty() && camera.name == nameOrIndex) return camera;
    }
    std::size_t index = 0;
    const char* end = nameOrIndex.data() + nameOrIndex.size();
    const auto [stop, error] = std::from_chars(nameOrIndex.data(), end, index);
    if (error == std::errc() && stop == end && index < scene.cameras.size()) return scene.cameras[index];

    std::string known;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        known += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, scene.cameras[i].name);
    }
    throw FileError(scene.path.string(), fmt::format("no camera '{}'; {}", nameOrIndex,
                                                     known.empty() ? "the file has none" : "it has " + known));
}

}  // namespace vkpt
