#include "scene/albedo_tables.h"

#include <algorithm>

namespace vkpt {
namespace {

bool isConductor(BsdfId model) { return model == BsdfId::Conductor; }

AlbedoTableKey keyOf(const BsdfRecord& record, bool conductor, bool texturedAlpha) {
    AlbedoTableKey key;
    key.distribution = static_cast<Distribution>(record.flags & kBsdfDistributionMask);
    key.masking = static_cast<Masking>(record.flags >> kBsdfMaskingShift & kBsdfMaskingMask);
    if (!conductor) key.eta = record.eta.x;
    if (record.alphaX != record.alphaY && !texturedAlpha)
        key.alpha = glm::max(glm::vec2(record.alphaX, record.alphaY), kDeltaAlpha);
    return key;
}

}  // namespace

AlbedoTables::AlbedoTables(bool multiscatter) : multiscatter_(multiscatter) {
    if (!multiscatter) return;
    made_.push_back({AlbedoTableKey{}});
    first_.push_back(0);
    cells_.assign(gltfAlbedoTable().begin(), gltfAlbedoTable().end());
}

void AlbedoTables::add(BsdfId model, bool texturedAlpha, BsdfRecord& record) {
    const bool interreflects = isConductor(model) || model == BsdfId::Dielectric;
    if (model != BsdfId::Plastic && !(multiscatter_ && interreflects)) return;
    if (std::max(record.alphaX, record.alphaY) < kDeltaAlpha) return;
    std::vector<AlbedoTableKey> keys{keyOf(record, isConductor(model), texturedAlpha)};
    if (!isConductor(model)) {
        keys.push_back(keys[0]);
        keys[1].eta = 1 / keys[0].eta;
    }
    if (keys[0].alpha) record.flags |= kBsdfAzimuthTable;
    record.table = find(keys);
}

std::uint32_t AlbedoTables::find(const std::vector<AlbedoTableKey>& keys) {
    const auto known = std::ranges::find(made_, keys);
    if (known != made_.end()) return first_[static_cast<std::size_t>(known - made_.begin())];
    const auto first = static_cast<std::uint32_t>(cells_.size());
    made_.push_back(keys);
    first_.push_back(first);
    for (const AlbedoTableKey& key : keys) {
        const std::vector<AlbedoCell> table = makeAlbedoTable(key);
        cells_.insert(cells_.end(), table.begin(), table.end());
    }
    return first;
}

}  // namespace vkpt
