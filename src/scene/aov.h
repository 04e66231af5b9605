// Arbitrary output variables: layers a render may gather beside its picture.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vkpt {

enum class Aov : std::uint32_t {
    Albedo,
    Normal,
    Depth,
    Position,
    Uv,
    Primitive,
    Instance,
    Material,
    Alpha,
    Samples,
    Variance,
};

struct AovInfo {
    Aov id;
    std::string_view name;      ///< on the command line, and of its layer in a file
    std::string_view channels;  ///< a letter each
    std::string_view help;
};

/// What is averaged is so over the paths of a pixel: all of them, or those that met a surface ("where met").
inline constexpr auto kAovs = std::to_array<AovInfo>({
    {Aov::Albedo, "albedo", "RGB", "base colour of the first surface; 0 where none is met"},
    {Aov::Normal, "normal", "XYZ", "its shading normal, world space, on the camera's side; 0 where none is met"},
    {Aov::Depth, "depth", "Z", "metres from the camera along its axis, where met"},
    {Aov::Position, "position", "XYZ", "world space, metres, where met"},
    {Aov::Uv, "uv", "UVA", "TEXCOORD_0, where met; A as alpha"},
    {Aov::Primitive, "primitive", "X", "number of the triangle that the first sample met"},
    {Aov::Instance, "instance", "X", "number of the mesh instance that it met"},
    {Aov::Material, "material", "X", "number of the material that it met"},
    {Aov::Alpha, "alpha", "A", "share of the paths that met a surface, whatever the background"},
    {Aov::Samples, "samples", "X", "samples a pixel"},
    {Aov::Variance, "variance", "Y", "sample variance of the paths' luminance"},
});

/// A set of AOVs; bit i stands for the Aov of value i.
struct AovSet {
    std::uint32_t bits = 0;

    [[nodiscard]] constexpr bool has(Aov aov) const { return (bits >> static_cast<std::uint32_t>(aov) & 1U) != 0; }
    constexpr void add(Aov aov) { bits |= 1U << static_cast<std::uint32_t>(aov); }
    [[nodiscard]] constexpr bool empty() const { return bits == 0; }
    friend bool operator==(const AovSet&, const AovSet&) = default;
};

inline constexpr AovSet kAllAovs{(1U << kAovs.size()) - 1};

/// "albedo,normal", in the order of kAovs; "none" of an empty set.
[[nodiscard]] std::string aovsText(AovSet aovs);

/// Names with commas between them, "all" or "none"; nothing where the text is anything else.
[[nodiscard]] std::optional<AovSet> parseAovs(std::string_view text);

}  // namespace vkpt
