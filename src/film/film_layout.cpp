#include "film/film_layout.h"

#include <fmt/format.h>

namespace vkpt {
namespace {

FilmWord sumWord(char component, std::string count = {}) {
    return {WordRule::Sum,
            {fmt::format("{}0", component), fmt::format("{}1", component), fmt::format("{}2", component),
             std::move(count)}};
}

std::vector<FilmWord> sumWords(std::string_view components) {
    std::vector<FilmWord> words;
    for (const char component : components) words.push_back(sumWord(component));
    return words;
}

struct LayerSource {
    std::string_view name;
    AovSet aovs;  ///< any of these needs the layer
    std::vector<FilmWord> words;
};

AovSet anyOf(std::initializer_list<Aov> aovs) {
    AovSet set;
    for (const Aov aov : aovs) set.add(aov);
    return set;
}

/// In the order of enum Layer.
std::array<LayerSource, kLayers> layerSources() {
    return {{{"albedo", anyOf({Aov::Albedo}), sumWords("RGB")},
             {"normal", anyOf({Aov::Normal}), sumWords("XYZ")},
             {"depth", anyOf({Aov::Depth}), sumWords("Z")},
             {"position", anyOf({Aov::Position}), sumWords("XYZ")},
             {"uv", anyOf({Aov::Uv}), sumWords("UV")},
             {"ids",
              anyOf({Aov::Primitive, Aov::Instance, Aov::Material}),
              {{WordRule::First, {"primitive", "instance", "material", "known"}}}},
             {"luminance",
              anyOf({Aov::Variance}),
              {sumWord('L', "refused"), {WordRule::WideSum, {"LL0", "LL1", "LL2", "LL3"}}}}}};
}

}  // namespace

FilmBlock beautyBlock() { return {"beauty", 0, {sumWord('R', "alpha"), sumWord('G', "surface"), sumWord('B')}}; }

FilmLayout::FilmLayout(AovSet aovs, LightLayers light) : aovs_(aovs), light_(std::move(light)) {
    firstWords_.fill(kNone);
    auto sources = layerSources();
    for (std::size_t i = 0; i < kLayers; ++i) {
        if ((sources[i].aovs.bits & aovs.bits) == 0) continue;
        firstWords_[i] = words_;
        words_ += static_cast<std::uint32_t>(sources[i].words.size());
        blocks_.push_back({std::string(sources[i].name), firstWords_[i], std::move(sources[i].words)});
    }
    lengthWord_ = addLight("length", light_.lengths);
    groupWord_ = addLight("group", light_.groups.size());
}

/// Blocks "length0", "length1", ...; the first word, kNone where there are none.
std::uint32_t FilmLayout::addLight(std::string_view kind, std::size_t count) {
    if (count == 0) return kNone;
    const std::uint32_t first = words_;
    for (std::size_t i = 0; i < count; ++i, words_ += kLightWords)
        blocks_.push_back({fmt::format("{}{}", kind, i), words_, sumWords("RGB")});
    return first;
}

bool FilmLayout::hasSurfaceLayer() const {
    for (const Layer layer : {Layer::Albedo, Layer::Normal, Layer::Depth, Layer::Position, Layer::Uv, Layer::Ids})
        if (has(layer)) return true;
    return false;
}

}  // namespace vkpt
