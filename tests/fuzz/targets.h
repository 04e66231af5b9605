// What is fuzzed. Each target takes any bytes and must come back: an exception other than Error, a sanitizer's report
// or a broken promise (abort) is a finding.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace vkpt::fuzz {

using Input = std::span<const std::uint8_t>;

void fuzzImport(Input bytes);  ///< a .gltf or .glb to a Scene
void fuzzImage(Input bytes);   ///< EXR, HDR, PFM and PNG to an Image; PNG and JPEG to texels
void fuzzScene(Input bytes);   ///< a .gltf or .glb to SceneArrays with lights, camera and BVH

struct Target {
    std::string_view name;
    void (*run)(Input);
};

inline constexpr Target kTargets[] = {{"import", fuzzImport}, {"image", fuzzImage}, {"scene", fuzzScene}};

}  // namespace vkpt::fuzz
