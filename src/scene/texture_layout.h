// Where the texels of images lie in SceneArrays: the maps of a material that are read at the same place side by side.
#pragma once
#include <array>

#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// One map of a material: what its slot reads, and its place among the roles (kMap*).
struct MaterialMap {
    const TextureUse* use = nullptr;  ///< null: no map
    bool srgb = false;
};

/// Places images and makes the texture records that refer to them. Each image is stored once, beside those it was first
/// met with; so a scene takes at most 4/3 of the memory of its images.
class TextureLayout {
public:
    TextureLayout(const Scene& scene, SceneArrays& arrays);

    /// Makes the records of a material's maps: their indices, the sets of its flags, its part of the features.
    /// Throws FileError where an image is too large.
    void add(const std::array<MaterialMap, kMapRoles>& maps, MaterialRecord& material);
    void copyTexels();

private:
    struct Place {
        std::uint32_t first = kNone, stride = 1;
    };
    struct Set;

    [[nodiscard]] std::vector<Set> groupMaps(const std::array<MaterialMap, kMapRoles>& maps) const;
    [[nodiscard]] bool canInterleave(const Set& set) const;
    void placeTogether(const Set& set);
    void checkSize(const TextureImage& image, std::uint64_t words) const;
    [[nodiscard]] std::uint32_t addRecord(const MaterialMap& map);
    [[nodiscard]] const TextureImage& imageOf(const TextureUse& use) const;
    [[nodiscard]] Place& placeOf(const TextureUse& use) { return places_[static_cast<std::size_t>(use.image)]; }
    [[nodiscard]] const Place& placeOf(const TextureUse& use) const {
        return places_[static_cast<std::size_t>(use.image)];
    }

    const Scene& scene_;
    SceneArrays& arrays_;
    std::vector<Place> places_;  ///< one an image
    std::uint64_t next_ = 0;
};

}  // namespace vkpt
