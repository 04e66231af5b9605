#include "wavefront/scene_upload.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/error.h"
#include "gpu/transfer.h"
#include "scene/pixel_filter.h"
#include "scene/sampler_table.h"

namespace vkpt {
namespace {

constexpr std::size_t kWord = 16;

/// Calls visit(section offset in the header, bytes) for every section, in the order they are stored.
template <class Layout, class Visit>
void forEachSection(const SceneArrays& a, Layout& layout, const Visit& visit) {
    auto& h = layout.header;
    visit(h.nodes, std::as_bytes(std::span(a.nodes)));
    visit(h.triangles, std::as_bytes(std::span(a.triangles)));
    visit(h.vertices, std::as_bytes(std::span(a.vertices)));
    visit(h.vertexExtras, std::as_bytes(std::span(a.vertexExtras)));
    visit(h.instances, std::as_bytes(std::span(a.instances)));
    visit(h.materials, std::as_bytes(std::span(a.materials)));
    visit(h.bsdfs, std::as_bytes(std::span(a.bsdfs)));
    visit(h.albedoTables, std::as_bytes(std::span(a.albedoTables)));
    visit(h.textures, std::as_bytes(std::span(a.textures)));
    visit(h.texels, std::as_bytes(std::span(a.texels)));
    visit(h.lights, std::as_bytes(std::span(a.lights)));
    visit(h.lightCdf, std::as_bytes(std::span(a.lightCdf)));
    visit(h.envTexels, std::as_bytes(std::span(a.envTexels)));
    visit(h.envRows, std::as_bytes(std::span(a.envRows)));
    visit(h.envColumns, std::as_bytes(std::span(a.envColumns)));
    visit(h.samplerTable, std::as_bytes(std::span(layout.samplerTable)));
    visit(h.filterTable, std::as_bytes(std::span(layout.filterTable)));
    visit(h.lightGroups, std::as_bytes(std::span(a.lightGroups.ofLight)));
    visit(h.objectGroups, std::as_bytes(std::span(a.lightGroups.ofObject)));
}

}  // namespace

SceneLayout planScene(const SceneArrays& arrays, SamplerChoice sampler, std::uint32_t lastIndex,
                      const RenderParams& params) {
    SceneLayout layout;
    layout.samplerTable = samplerTable(sampler, lastIndex);
    layout.filterTable = filterTable(params);
    if (arrays.triangles.size() <= kListMax) layout.list.assign(arrays.triangles.begin(), arrays.triangles.end());
    std::size_t words = 0;
    forEachSection(arrays, layout, [&](uint& offset, std::span<const std::byte> bytes) {
        if (words >= kNone) throw DeviceError("the scene needs more than 64 GiB on the device");
        offset = bytes.empty() ? kNone : static_cast<uint>(words);
        words += (bytes.size() + kWord - 1) / kWord;
    });
    if (words >= kNone) throw DeviceError("the scene needs more than 64 GiB on the device");
    layout.bytes = std::max(words, std::size_t{1}) * kWord;  // an empty buffer could not be bound
    SceneHeader& h = layout.header;
    h.lightCount = static_cast<uint>(arrays.lights.size());
    h.rootNode = arrays.rootNode;
    h.envLight = arrays.envLight;
    h.envWidth = arrays.envWidth;
    h.envHeight = arrays.envHeight;
    h.envCos = std::cos(arrays.envRotation);
    h.envSin = std::sin(arrays.envRotation);
    h.groupBehind = arrays.lightGroups.behind;
    return layout;
}

Frame makeFrame(const SceneLayout& layout, const RenderParams& params) {
    Frame frame{layout.header, params, {}};
    std::ranges::copy(layout.list, frame.list.begin());
    return frame;
}

void uploadScene(Device& device, const Buffer& buffer, const SceneArrays& arrays, const SceneLayout& layout) {
    forEachSection(arrays, layout, [&](const uint& offset, std::span<const std::byte> bytes) {
        if (!bytes.empty()) uploadBuffer(device, buffer, offset * kWord, bytes);
    });
}

}  // namespace vkpt
