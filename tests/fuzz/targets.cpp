#include "fuzz/targets.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "base/image_read.h"
#include "bvh/build.h"
#include "gltf/images.h"
#include "gltf/import.h"
#include "scene/camera.h"
#include "scene/default_light.h"
#include "scene/environment.h"
#include "scene/flatten.h"
#include "scene/info.h"

namespace vkpt::fuzz {
namespace {

/// Nothing is there, so that no input can read a file.
const std::filesystem::path kFile = "/nonexistent/fuzz.gltf";

void promise(bool kept, const char* what) {
    if (kept) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

/// Runs `work`; its refusals must be one line that names the file, with exit code 4.
template <typename Work>
void refusingWell(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        const std::string_view message = error.what();
        promise(error.code() == ExitCode::File, "a refused file ends with exit code 4");
        promise(message.find('\n') == std::string_view::npos, "a refusal is one line");
        promise(message.starts_with(kFile.native()), "a refusal names the file");
    }
}

void checkPrimitive(const Primitive& p, const Scene& scene) {
    const std::size_t n = p.positions.size();
    promise(p.normals.size() == n, "a normal for each vertex");
    for (const std::size_t size : {p.tangents.size(), p.uv0.size(), p.uv1.size(), p.colors.size()})
        promise(size == 0 || size == n, "attributes of one length");
    promise(p.material < scene.materials.size(), "a material that is there");
    for (const glm::uvec3& t : p.triangles) promise(t.x < n && t.y < n && t.z < n, "indices of vertices");
    for (const glm::vec3& v : p.positions)
        promise(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "finite positions");
    for (const glm::vec3& v : p.normals) promise(std::abs(glm::dot(v, v) - 1) < 1e-4F, "unit normals");
}

void checkScene(const Scene& scene) {
    promise(!scene.materials.empty(), "a material");
    promise(scene.files.empty(), "no other file is read");
    for (const MeshInstance& instance : scene.instances)
        promise(instance.mesh < scene.meshes.size(), "instances of meshes that are there");
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) checkPrimitive(primitive, scene);
    for (const TextureImage& image : scene.images)
        promise(image.texels.size() == std::size_t{image.width} * image.height, "all texels");
    for (const std::string& warning : scene.warnings)
        promise(warning.find('\n') == std::string::npos, "a warning is one line");
}

void checkArrays(const SceneArrays& arrays) {
    for (const TriangleRecord& t : arrays.triangles) {
        promise(std::max({t.i0, t.i1, t.i2}) < arrays.vertices.size(), "triangles of vertices that are there");
        promise((t.flags >> kTriangleMaterialShift) < arrays.materials.size(), "triangles of materials that are there");
        promise(t.light == kNone || t.light < arrays.lights.size(), "triangles of lights that are there");
    }
    for (const LightRecord& light : arrays.lights) promise(light.pmf > 0 && light.pmf <= 1, "lights with a chance");
    for (const float c : arrays.lightCdf) promise(c >= 0 && c <= 1, "a table within [0, 1]");
    promise(arrays.rootNode < arrays.nodes.size(), "a root that is there");
}

}  // namespace

void fuzzImport(Input bytes) {
    refusingWell([&] { checkScene(importGltf(bytes, kFile)); });
}

void fuzzImage(Input bytes) {
    refusingWell([&] {
        const Image image = decodeImage(kFile.string(), bytes);
        promise(image.channels > 0 && image.pixels.size() == std::size_t{image.width} * image.height * image.channels,
                "all pixels");
    });
    for (const auto decode : {gltf::decodePng, gltf::decodeJpeg}) {
        std::string fault;
        const TextureImage image = decode(std::as_bytes(bytes), fault);
        promise(image.texels.size() == std::size_t{image.width} * image.height, "all texels");
        promise(!image.texels.empty() || !fault.empty(), "a reason");
    }
}

void fuzzScene(Input bytes) {
    refusingWell([&] {
        const Scene scene = importGltf(bytes, kFile);
        SceneArrays arrays = flatten(scene);
        if (!hasOwnLight(arrays)) addEnvironment(arrays, constantEnvironment(glm::vec3(1)), 1, 0);
        buildBvh(arrays);
        checkArrays(arrays);
        RenderParams params{};
        params.width = params.height = 8;
        frameScene(params, arrays, kDefaultFov);
        for (const Camera& camera : scene.cameras) fromCamera(params, scene, camera);
        (void)sceneInfoText(sceneInfo(scene, arrays));
    });
}

}  // namespace vkpt::fuzz
