// What the words of a pixel mean: the beauty, then a block for every layer that was asked for.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "constants.h"
#include "scene/aov.h"
#include "scene/light_layers.h"

namespace vkpt {

/// How a word of two disjoint ranges of samples becomes that of both.
enum class WordRule : std::uint8_t {
    Sum,      ///< x, y, z: one integer of 96 bits, lowest first, modulo 2^96; w: a count of its own
    WideSum,  ///< x to w: one integer of 128 bits
    First,    ///< the word of whichever range holds the lowest sample index
};

/// One 16-byte word of a pixel.
struct FilmWord {
    WordRule rule;
    std::array<std::string, 4> channels;  ///< what x, y, z and w are called in a file; empty: always 0, not stored
};

/// Consecutive words of a pixel that belong together.
struct FilmBlock {
    std::string name;
    std::uint32_t firstWord = 0;
    std::vector<FilmWord> words;
};

/// The words of FilmSums: red, green, blue; w of red: paths that met a surface or a visible background, w of green:
/// paths that met a surface.
[[nodiscard]] FilmBlock beautyBlock();

/// Blocks that a render can gather beside the beauty. Several AOVs may come from one.
enum class Layer : std::uint32_t { Albedo, Normal, Depth, Position, Uv, Ids, Luminance };
inline constexpr std::size_t kLayers = 7;

/// Words of one layer of light: red, green, blue.
inline constexpr std::uint32_t kLightWords = 3;

/// The words of a pixel beside FilmSums: those of the AOVs, of light by length, of light by group. Both renderers
/// gather what it lists, merging and files follow it; a layer of another kind is one more block.
class FilmLayout {
public:
    FilmLayout() { firstWords_.fill(kNone); }
    explicit FilmLayout(AovSet aovs, LightLayers light = {});

    [[nodiscard]] AovSet aovs() const { return aovs_; }
    [[nodiscard]] const LightLayers& light() const { return light_; }
    /// The first word of the layers of light by length, kLightWords each, or kNone; the same by group.
    [[nodiscard]] std::uint32_t lengthWord() const { return lengthWord_; }
    [[nodiscard]] std::uint32_t groupWord() const { return groupWord_; }
    [[nodiscard]] std::uint32_t words() const { return words_; }
    [[nodiscard]] const std::vector<FilmBlock>& blocks() const { return blocks_; }
    /// The first word of a layer, or kNone where it is not gathered.
    [[nodiscard]] std::uint32_t firstWord(Layer layer) const { return firstWords_[static_cast<std::size_t>(layer)]; }
    [[nodiscard]] bool has(Layer layer) const { return firstWord(layer) != kNone; }
    /// Some layer describes the surface that the camera ray met.
    [[nodiscard]] bool hasSurfaceLayer() const;

private:
    std::uint32_t addLight(std::string_view kind, std::size_t count);

    AovSet aovs_;
    LightLayers light_;
    std::uint32_t lengthWord_ = kNone, groupWord_ = kNone;
    std::uint32_t words_ = 0;
    std::array<std::uint32_t, kLayers> firstWords_{};
    std::vector<FilmBlock> blocks_;
};

}  // namespace vkpt
