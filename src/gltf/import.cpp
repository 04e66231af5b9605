// The order of an import: JSON, hierarchy, materials, then geometry and images on all cores.
#include "gltf/import.h"

#include <optional>

#include "base/printable.h"
#include "gltf/attachments.h"
#include "gltf/extensions.h"
#include "gltf/geometry.h"
#include "gltf/images.h"
#include "gltf/materials.h"
#include "gltf/nodes.h"
#include "gltf/task.h"

namespace vkpt {
namespace {

using namespace gltf;

/// One primitive of the file that something places.
struct PrimitiveTask {
    std::size_t meshIndex = 0, primitive = 0;  // in the file
    std::uint32_t mesh = 0;                    // in the Scene
    int material = -1;                         // in the file; -1: the default
};

constexpr std::uint32_t kUnused = 0xffffffffU;

/// Collects what the scene places. Materials and meshes are numbered anew, in the file's order.
class Importer {
public:
    Importer(const Document& document, const ImportOptions& options, Scene& scene)
        : document_(document), options_(options), scene_(scene) {}

    void run(const std::vector<PlacedNode>& placed) {
        placeMeshes(placed);
        for (const PlacedNode& node : placed) readAttachments(document_, node, scene_);
        readMaterials();
        readGeometryAndImages();
    }

private:
    void placeMeshes(const std::vector<PlacedNode>& placed);
    void readMaterials();
    void readGeometryAndImages();
    [[nodiscard]] std::uint32_t materialOf(const PrimitiveTask& task) const {
        return task.material >= 0 ? materialNumber_[task.material] : defaultMaterial_;
    }

    const Document& document_;
    const ImportOptions& options_;
    Scene& scene_;
    std::vector<PrimitiveTask> tasks_;
    std::vector<std::uint32_t> materialNumber_;
    std::uint32_t defaultMaterial_ = kUnused;
};

void Importer::placeMeshes(const std::vector<PlacedNode>& placed) {
    constexpr std::uint32_t kWanted = 0;
    const tinygltf::Model& model = document_.model();
    std::vector<std::uint32_t> number(model.meshes.size(), kUnused);
    for (const PlacedNode& node : placed)
        if (const int mesh = model.nodes[node.node].mesh; mesh >= 0) number[mesh] = kWanted;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == kUnused) continue;
        number[i] = static_cast<std::uint32_t>(scene_.meshes.size());
        scene_.meshes.push_back({model.meshes[i].name, {}});
        const auto& primitives = model.meshes[i].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) tasks_.push_back({i, p, number[i], primitives[p].material});
    }
    for (const PlacedNode& node : placed) {
        const tinygltf::Node& source = model.nodes[node.node];
        if (source.mesh < 0) continue;
        const std::uint32_t index = number[source.mesh];
        const std::string& name = source.name.empty() ? scene_.meshes[index].name : source.name;
        scene_.instances.push_back({name, index, glm::mat4(node.world)});
    }
}

void Importer::readMaterials() {
    materialNumber_.assign(document_.model().materials.size(), kUnused);
    bool needsDefault = tasks_.empty();
    for (const PrimitiveTask& task : tasks_) {
        if (task.material >= 0)
            materialNumber_[task.material] = 0;
        else
            needsDefault = true;
    }
    for (std::size_t i = 0; i < materialNumber_.size(); ++i) {
        if (materialNumber_[i] == kUnused) continue;
        materialNumber_[i] = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materials.push_back(readMaterial(document_, i, scene_.warnings));
    }
    if (needsDefault) {
        defaultMaterial_ = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materials.emplace_back().name = "default";
    }
    if (options_.editMaterials) options_.editMaterials(scene_.materials);
}

void Importer::readGeometryAndImages() {
    const std::vector<std::size_t> images = collectImages(document_, scene_.materials);
    std::vector<std::optional<Primitive>> primitives(tasks_.size());
    std::vector<Skipped> skipped(tasks_.size());
    scene_.images.resize(images.size());
    runTasks(images.size() + tasks_.size(), scene_.warnings, [&](std::size_t i, std::vector<std::string>& said) {
        if (i < images.size()) {
            scene_.images[i] = loadImage(document_, images[i], said);
            return;
        }
        const std::size_t t = i - images.size();
        const Material& material = scene_.materials[materialOf(tasks_[t])];
        primitives[t] = readPrimitive(document_, tasks_[t].meshIndex, tasks_[t].primitive, material, skipped[t], said);
    });

    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        scene_.skippedPoints += skipped[i].points;
        scene_.skippedLines += skipped[i].lines;
        if (!primitives[i]) continue;
        primitives[i]->material = materialOf(tasks_[i]);
        scene_.meshes[tasks_[i].mesh].primitives.push_back(std::move(*primitives[i]));
    }
    if (scene_.skippedPoints > 0)
        scene_.warnings.push_back(fmt::format("{} points are skipped; only triangles are drawn", scene_.skippedPoints));
    if (scene_.skippedLines > 0)
        scene_.warnings.push_back(fmt::format("{} lines are skipped; only triangles are drawn", scene_.skippedLines));
}

}  // namespace

Scene importGltf(const std::filesystem::path& file, const ImportOptions& options) {
    return importGltf(readFile(file, file.string(), ""), file, options);
}

Scene importGltf(std::span<const unsigned char> bytes, const std::filesystem::path& file,
                 const ImportOptions& options) {
    const Document document(bytes, file, options.allowExternal ? Reach::Anywhere : Reach::Folder);
    Scene scene;
    scene.path = file;
    scene.warnings = document.warnings();
    reportExtensions(document, scene);
    Importer(document, options, scene).run(placeNodes(document, options.scene, scene.warnings));
    scene.files = document.filesRead();
    for (std::string& warning : scene.warnings) warning = printable(std::move(warning));
    return scene;
}

}  // namespace vkpt
