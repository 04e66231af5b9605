#include "gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace vkpt::gltf {
namespace {

glm::dvec3 vectorOr(const std::vector<double>& v, double fallback) {
    return v.empty() ? glm::dvec3(fallback) : glm::make_vec3(v.data());
}

glm::dquat rotationOf(const tinygltf::Node& node) {
    if (node.rotation.empty()) return {1, 0, 0, 0};
    const auto& r = node.rotation;
    return glm::normalize(glm::dquat(r[3], r[0], r[1], r[2]));
}

/// The node's matrix, or translation * rotation * scale. [glTF 2.0, §3.5.3]
glm::dmat4 localTransform(const tinygltf::Node& node) {
    if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), vectorOr(node.translation, 0));
    return glm::scale(moved * glm::mat4_cast(rotationOf(node)), vectorOr(node.scale, 1));
}

bool fitsFloat(const glm::dmat4& m) {
    const double* value = glm::value_ptr(m);
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(static_cast<float>(value[i]))) return false;
    return true;
}

std::vector<int> nodesWithoutParent(const Document& document) {
    const auto& nodes = document.model().nodes;
    std::vector<bool> isChild(nodes.size(), false);
    for (const tinygltf::Node& node : nodes)
        for (const int child : node.children) isChild[child] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!isChild[i]) roots.push_back(static_cast<int>(i));
    if (roots.empty() && !nodes.empty()) document.fail("nodes: every node is the child of another; there is a cycle");
    return roots;
}

std::vector<int> rootsOf(const Document& document, int scene, std::vector<std::string>& warnings) {
    const tinygltf::Model& model = document.model();
    const std::size_t scenes = model.scenes.size();
    if (scene >= 0 && static_cast<std::size_t>(scene) >= scenes)
        document.fail("scene {} does not exist; the file has {}", scene, scenes);
    if (scenes == 0) {
        warnings.emplace_back("the file has no scene; all its nodes are shown");
        return nodesWithoutParent(document);
    }
    return model.scenes[scene >= 0 ? scene : std::max(model.defaultScene, 0)].nodes;
}

}  // namespace

std::vector<PlacedNode> placeNodes(const Document& document, int scene, std::vector<std::string>& warnings) {
    const std::vector<int> roots = rootsOf(document, scene, warnings);
    std::vector<bool> reached(document.model().nodes.size(), false);
    std::vector<PlacedNode> placed, pending;  // pending: a stack, so that depth costs no recursion
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.push_back({static_cast<std::size_t>(*root), glm::dmat4(1)});
    while (!pending.empty()) {
        PlacedNode next = pending.back();
        pending.pop_back();
        if (reached[next.node])
            document.fail("nodes[{}]: is reached twice; nodes must form a tree, without cycles or shared children",
                          next.node);
        reached[next.node] = true;
        const tinygltf::Node& node = document.model().nodes[next.node];
        next.world = next.world * localTransform(node);
        if (!fitsFloat(next.world)) document.fail("nodes[{}]: its transform is not finite", next.node);
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            pending.push_back({static_cast<std::size_t>(*child), next.world});
        placed.push_back(next);
    }
    return placed;
}

glm::mat4 withoutScale(const glm::dmat4& world) {
    glm::dmat4 result = world;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double length = glm::length(glm::dvec3(world[axis]));
        if (length > 0) result[axis] = glm::dvec4(glm::dvec3(world[axis]) / length, 0);
    }
    return glm::mat4(result);
}

}  // namespace vkpt::gltf
