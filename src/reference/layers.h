// The film's layers beside the beauty, gathered path by path. estimator.md, Layers.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "film/film_layout.h"
#include "reference/hit.h"

namespace vkpt::reference {

/// What a contribution came from.
struct LightOrigin {
    std::uint32_t scatterings = 0;  ///< on its way to the camera
    std::uint32_t group = 0;
};

/// Adds single paths to the layers of one pixel.
class LayerTally {
public:
    /// `words` are those of the pixel. All arguments must outlive this.
    LayerTally(const SceneArrays& scene, const RenderParams& params, const FilmLayout& layout, std::span<uvec4> words)
        : scene_(scene), params_(params), layout_(layout), words_(words) {}

    /// What the camera ray met, or that it met nothing. Called in the order of sample indices.
    void addFirstHit(const Ray& ray, const std::optional<Hit>& hit);
    /// One contribution, in fixed point.
    void addLight(const FilmSums& contribution, const LightOrigin& origin);
    /// A finished path; `sums` are its contributions alone.
    void addPath(const FilmSums& sums);

    /// Values that were not a number or out of range.
    [[nodiscard]] std::uint64_t refused() const { return refused_; }

private:
    void addValue(Layer layer, std::initializer_list<float> value);
    void addLight(std::uint32_t firstWord, const FilmSums& contribution);
    void keepFirstIds(const std::optional<Hit>& hit);
    [[nodiscard]] uvec4& word(Layer layer, std::size_t i) { return words_[layout_.firstWord(layer) + i]; }

    const SceneArrays& scene_;
    const RenderParams& params_;
    const FilmLayout& layout_;
    std::span<uvec4> words_;
    std::uint64_t refused_ = 0;
};

}  // namespace vkpt::reference
