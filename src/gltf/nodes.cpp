#include "gltf/nodes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace vkpt::gltf {
namespace {

glm::dvec3 vectorOr(const Json& node, std::string_view key, double fallback) {
    const Json& v = member(node, key);
    if (v.is_null()) return glm::dvec3(fallback);
    return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

glm::dquat rotationOf(const Json& node) {
    const Json& r = member(node, "rotation");
    if (r.is_null()) return {1, 0, 0, 0};
    const glm::dquat q(r[3].get<double>(), r[0].get<double>(), r[1].get<double>(), r[2].get<double>());
    return glm::dot(q, q) > 0 ? glm::normalize(q) : glm::dquat(1, 0, 0, 0);
}

/// The node's matrix, or translation * rotation * scale. [glTF 2.0, §3.5.3]
glm::dmat4 localTransform(const Json& node) {
    const Json& matrix = member(node, "matrix");
    if (!matrix.is_null()) {
        glm::dmat4 m;
        for (std::size_t i = 0; i < 16; ++i) glm::value_ptr(m)[i] = matrix[i].get<double>();
        return m;
    }
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), vectorOr(node, "translation", 0));
    return glm::scale(moved * glm::mat4_cast(rotationOf(node)), vectorOr(node, "scale", 1));
}

bool fitsFloat(const glm::dmat4& m) {
    const double* value = glm::value_ptr(m);
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(static_cast<float>(value[i]))) return false;
    return true;
}

std::vector<std::size_t> nodesWithoutParent(const Document& document) {
    const std::size_t n = document.count("nodes");
    std::vector<bool> isChild(n, false);
    for (std::size_t i = 0; i < n; ++i)
        for (const Json& child : member(document.item("nodes", i), "children"))
            isChild[child.get<std::size_t>()] = true;
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < n; ++i)
        if (!isChild[i]) roots.push_back(i);
    if (roots.empty() && n > 0) document.fail("nodes: every node is the child of another; there is a cycle");
    return roots;
}

std::vector<std::size_t> rootsOf(const Document& document, int scene, std::vector<std::string>& warnings) {
    const std::size_t scenes = document.count("scenes");
    if (scene >= 0 && static_cast<std::size_t>(scene) >= scenes)
        document.fail("scene {} does not exist; the file has {}", scene, scenes);
    if (scenes == 0) {
        warnings.emplace_back("the file has no scene; all its nodes are shown");
        return nodesWithoutParent(document);
    }
    const std::size_t chosen =
        scene >= 0 ? static_cast<std::size_t>(scene) : valueOr(document.root(), "scene", std::size_t{0});
    std::vector<std::size_t> roots;
    for (const Json& node : member(document.item("scenes", chosen), "nodes")) roots.push_back(node.get<std::size_t>());
    return roots;
}

}  // namespace

std::vector<PlacedNode> placeNodes(const Document& document, int scene, std::vector<std::string>& warnings) {
    const std::vector<std::size_t> roots = rootsOf(document, scene, warnings);
    std::vector<bool> reached(document.count("nodes"), false);
    std::vector<PlacedNode> placed, pending;  // pending: a stack, so that depth costs no recursion
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) pending.push_back({*root, glm::dmat4(1)});
    while (!pending.empty()) {
        PlacedNode next = pending.back();
        pending.pop_back();
        if (reached[next.node])
            document.fail("nodes[{}]: is reached twice; nodes must form a tree, without cycles or shared children",
                          next.node);
        reached[next.node] = true;
        const Json& node = document.item("nodes", next.node);
        next.world = next.world * localTransform(node);
        if (!fitsFloat(next.world)) document.fail("nodes[{}]: its transform is not finite", next.node);
        const Json& children = member(node, "children");
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            pending.push_back({child->get<std::size_t>(), next.world});
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
