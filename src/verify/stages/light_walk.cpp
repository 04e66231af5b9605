#include "verify/stages/light_walk.h"

#include <algorithm>

namespace vkpt {
namespace {

void addTo(PathSums& sums, const PathSums& change) {
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] = (sums[c] + change[c]) % kModulus;
}

/// Layer `layer` of those that begin at `firstWord` in `words`, those of one pixel.
PathSums layerOf(const uvec4* words, std::uint32_t firstWord, std::size_t layer) {
    PathSums sums;
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] = sumOf(words[firstWord + layer * kLightWords + c]);
    return sums;
}

}  // namespace

void LightWalk::add(const StageSnapshot& before, const StageSnapshot& now, std::uint32_t path,
                    std::uint32_t scatterings, std::uint32_t group) {
    const bool begins = now.batch.bounce == 0 && now.batch.round == 0 && now.stage != Stage::Shadow;
    const PathSums change = changeOf(begins ? PathSums{} : sumsOf(before, path), sumsOf(now, path));
    const std::size_t pixel = placeOfSlot(now.batch, path).pixel - now.batch.firstPixel;
    const LightLayers& light = layout_.light();
    if (light.lengths > 0) addTo(lengths_[pixel * light.lengths + std::min(scatterings, light.lengths - 1)], change);
    if (group < light.groups.size()) addTo(groups_[pixel * light.groups.size() + group], change);
}

void LightWalk::see(const DevicePaths& paths, const StageSnapshot& before, const StageSnapshot& now) {
    if (layout_.light().empty()) return;
    const std::uint32_t bounce = now.batch.bounce;
    if (now.stage == Stage::Generate && now.batch.round == 0) {
        lengths_.assign(std::size_t{now.batch.pixelCount} * layout_.light().lengths, {});
        groups_.assign(now.batch.pixelCount * layout_.light().groups.size(), {});
    } else if (now.stage == Stage::Miss) {
        for (const std::uint32_t path : before.queue(bounce, Queue::Miss))
            add(before, now, path, bounce, scene_.lightGroups.behind);
    } else if (shadeGroupOf(now.stage) < kShadeStages.size()) {
        for (const std::uint32_t path : before.queue(bounce, kHitQueues[shadeGroupOf(now.stage)]))
            add(before, now, path, bounce, reference::emitterGroup(scene_, paths.hitOf(before, path)));
    } else if (now.stage == Stage::Shadow) {
        for (std::uint32_t item = 0; item < before.queueSize(bounce, Queue::Shadow); ++item) {
            const DeviceShadow shadow = shadowOf(before, item);
            add(before, now, shadow.path, bounce + 1, shadow.light.group);
        }
    }
}

void LightWalk::compare(Findings& findings, const ObservedFilm& film, std::uint32_t samples) {
    if (layout_.light().empty()) return;
    const std::size_t lengths = layout_.light().lengths, groups = layout_.light().groups.size();
    for (std::size_t pixel = 0; pixel < film.sums.size(); ++pixel) {
        findings.at(pixel * samples);
        const uvec4* words = film.layers.data() + pixel * layout_.words();
        for (std::size_t i = 0; i < lengths; ++i)
            findings.holds("light by length", layerOf(words, layout_.lengthWord(), i) == lengths_[pixel * lengths + i],
                           "is not the sum of what was added");
        for (std::size_t i = 0; i < groups; ++i)
            findings.holds("light by group", layerOf(words, layout_.groupWord(), i) == groups_[pixel * groups + i],
                           "is not the sum of what was added");
    }
}

}  // namespace vkpt
