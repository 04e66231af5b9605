#include "reference/layers.h"

#include <algorithm>

#include "reference/accumulate.h"
#include "reference/geometry.h"
#include "reference/looks.h"
#include "reference/material.h"

namespace vkpt::reference {

void LayerTally::addFirstHit(const Ray& ray, const std::optional<Hit>& hit) {
    if (layout_.has(Layer::Ids)) keepFirstIds(hit);
    if (!hit || !layout_.hasSurfaceLayer()) return;
    const TriangleRecord& triangle = scene_.triangles[hit->triangle];
    const Attributes attributes = interpolateAttributes(scene_, triangle, hit->barycentrics);
    const ShadingPoint point = makeShadingPoint(scene_, *hit, attributes, -ray.direction);
    const glm::vec4 base = baseColor(scene_, materialOf(scene_, triangle), attributes);
    const glm::vec3 &p = point.position, &n = point.ns;
    addValue(Layer::Albedo, {base.r, base.g, base.b});
    addValue(Layer::Normal, {n.x, n.y, n.z});
    addValue(Layer::Depth, {depthOf(params_, p)});
    addValue(Layer::Position, {p.x, p.y, p.z});
    addValue(Layer::Uv, {attributes.coords.uv0.x, attributes.coords.uv0.y});
}

void LayerTally::addLight(const FilmSums& contribution, const LightOrigin& origin) {
    const LightLayers& light = layout_.light();
    if (light.lengths > 0) {
        const std::uint32_t layer = std::min(origin.scatterings, light.lengths - 1);
        addLight(layout_.lengthWord() + layer * kLightWords, contribution);
    }
    if (!light.groups.empty()) addLight(layout_.groupWord() + origin.group * kLightWords, contribution);
}

void LayerTally::addLight(std::uint32_t firstWord, const FilmSums& contribution) {
    const auto add = [&](std::uint32_t i, const uvec4& sum) {
        addFixedPoint(words_[firstWord + i], {sum.x, sum.y, sum.z});
    };
    add(0, contribution.red);
    add(1, contribution.green);
    add(2, contribution.blue);
}

void LayerTally::addPath(const FilmSums& sums) {
    if (!layout_.has(Layer::Luminance)) return;
    uvec4& first = word(Layer::Luminance, 0);
    if (const auto luminance = pathLuminance(sums)) {
        addFixedPoint(first, wordsOf(*luminance));
        addSquare(word(Layer::Luminance, 1), *luminance);
    } else {
        ++first.w;
    }
}

/// Refused whole, and counted once, where a component is not in range.
void LayerTally::addValue(Layer layer, std::initializer_list<float> value) {
    if (!layout_.has(layer)) return;
    if (!std::ranges::all_of(value, [](float v) { return std::abs(v) < kLayerLimit; })) {
        ++refused_;
        return;
    }
    std::size_t i = 0;
    for (const float v : value) addFixedPoint(word(layer, i++), toSignedFixedPoint(v));
}

void LayerTally::keepFirstIds(const std::optional<Hit>& hit) {
    uvec4& ids = word(Layer::Ids, 0);
    if (ids.w != 0) return;
    ids = uvec4(kNone, kNone, kNone, 1);
    if (!hit) return;
    const TriangleRecord& triangle = scene_.triangles[hit->triangle];
    ids.x = triangle.primitive;
    ids.y = objectOf(scene_, *hit);
    ids.z = triangle.flags >> kTriangleMaterialShift;
}

}  // namespace vkpt::reference
