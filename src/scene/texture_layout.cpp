#include "scene/texture_layout.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "base/error.h"

namespace vkpt {
namespace {

std::uint32_t wrapBits(Wrap wrap) {
    if (wrap == Wrap::ClampToEdge) return kWrapClamp;
    return wrap == Wrap::MirroredRepeat ? kWrapMirror : kWrapRepeat;
}

/// Both are read at the same coordinates of the unit square, and filtered alike.
bool readAlike(const TextureUse& a, const TextureUse& b) {
    return a.wrapS == b.wrapS && a.wrapT == b.wrapT && a.nearest == b.nearest && a.uvSet == b.uvSet &&
           a.rowU == b.rowU && a.rowV == b.rowV;
}

}  // namespace

/// Maps of one material that can be read together, in the order of their roles.
struct TextureLayout::Set {
    std::vector<const TextureUse*> uses;
    std::uint32_t roles = 0;

    void add(std::uint32_t role, const TextureUse& use) {
        uses.push_back(&use);
        roles |= 1U << role;
    }
};

TextureLayout::TextureLayout(const Scene& scene, SceneArrays& arrays)
    : scene_(scene), arrays_(arrays), places_(scene.images.size()) {}

const TextureImage& TextureLayout::imageOf(const TextureUse& use) const {
    return scene_.images[static_cast<std::size_t>(use.image)];
}

std::vector<TextureLayout::Set> TextureLayout::groupMaps(const std::array<MaterialMap, kMapRoles>& maps) const {
    std::vector<Set> sets;
    for (std::uint32_t role = 0; role < kMapRoles; ++role) {
        const TextureUse* use = maps[role].use;
        if (use == nullptr) continue;
        const auto fits = [&](const Set& set) {
            const TextureUse& first = *set.uses.front();
            return readAlike(first, *use) && imageOf(first).width == imageOf(*use).width &&
                   imageOf(first).height == imageOf(*use).height &&
                   std::ranges::none_of(set.uses, [&](const TextureUse* u) { return u->image == use->image; });
        };
        const auto found = std::ranges::find_if(sets, fits);
        (found != sets.end() ? *found : sets.emplace_back()).add(role, *use);
    }
    return sets;
}

/// Whether the images of a set lie side by side, or can be placed so.
bool TextureLayout::canInterleave(const Set& set) const {
    const auto& uses = set.uses;
    if (std::ranges::all_of(uses, [&](const TextureUse* u) { return placeOf(*u).first == kNone; })) return true;
    const Place& first = placeOf(*uses.front());
    for (std::size_t i = 1; i < uses.size(); ++i) {
        const Place& place = placeOf(*uses[i]);
        if (place.first != first.first + i || place.stride != first.stride || place.first / 4 != first.first / 4)
            return false;
    }
    return true;
}

void TextureLayout::checkSize(const TextureImage& image, std::uint64_t words) const {
    if (image.width > 0xffff || image.height > 0xffff || next_ + words >= kNone) {
        throw FileError(scene_.path.string(), "image '" + image.name +
                                                  "': too large; give one of at most "
                                                  "65535 pixels a side, and fewer than 2^32 pixels in all");
    }
}

/// Places the images of a set side by side, unless they are placed already.
void TextureLayout::placeTogether(const Set& set) {
    if (placeOf(*set.uses.front()).first != kNone) return;
    const TextureImage& image = imageOf(*set.uses.front());
    const auto stride = static_cast<std::uint32_t>(std::bit_ceil(set.uses.size()));
    const std::uint64_t words = image.texels.size() * stride;
    if (stride > 1) next_ = (next_ + 3) / 4 * 4;
    checkSize(image, words);
    for (std::uint32_t i = 0; i < set.uses.size(); ++i)
        placeOf(*set.uses[i]) = {static_cast<std::uint32_t>(next_) + i, stride};
    next_ += words;
}

std::uint32_t TextureLayout::addRecord(const MaterialMap& map) {
    const TextureUse& use = *map.use;
    const TextureImage& image = imageOf(use);
    TextureRecord record{};
    record.texels = placeOf(use).first;
    record.stride = placeOf(use).stride;
    record.size = image.width | image.height << 16U;
    record.flags = (map.srgb ? kTextureSrgb : 0) | (use.nearest ? kTextureNearest : 0) |
                   (use.uvSet == 1 ? kTextureUv1 : 0) | wrapBits(use.wrapS) << kTextureWrapSShift |
                   wrapBits(use.wrapT) << kTextureWrapTShift;
    record.rowU = glm::vec4(use.rowU, 0);
    record.rowV = glm::vec4(use.rowV, 0);
    arrays_.textures.push_back(record);
    return static_cast<std::uint32_t>(arrays_.textures.size() - 1);
}

void TextureLayout::add(const std::array<MaterialMap, kMapRoles>& maps, MaterialRecord& material) {
    std::vector<Set> sets;
    for (const Set& set : groupMaps(maps)) {
        if (canInterleave(set)) {
            sets.push_back(set);
            placeTogether(set);
            continue;
        }
        std::size_t next = 0;
        for (std::uint32_t role = 0; role < kMapRoles; ++role) {
            if ((set.roles & 1U << role) == 0) continue;
            sets.emplace_back().add(role, *set.uses[next++]);
            placeTogether(sets.back());
        }
    }
    arrays_.features.mapSets = std::max(arrays_.features.mapSets, static_cast<std::uint32_t>(sets.size()));
    for (std::size_t i = 0; i < sets.size(); ++i)
        material.flags |= sets[i].roles << (kMaterialMapSetShift + kMapRoles * i);
    const std::array<std::uint32_t*, kMapRoles> slots = {&material.baseColorTexture, &material.metallicRoughnessTexture,
                                                         &material.normalTexture, &material.emissiveTexture};
    for (std::uint32_t role = 0; role < kMapRoles; ++role) {
        *slots[role] = kNone;
        if (maps[role].use == nullptr) continue;
        *slots[role] = addRecord(maps[role]);
        arrays_.features.maps |= 1U << role;
    }
}

void TextureLayout::copyTexels() {
    arrays_.texels.resize((next_ + 3) / 4 * 4);  // whole words
    tbb::parallel_for(std::size_t{0}, scene_.images.size(), [&](std::size_t i) {
        const Place& place = places_[i];
        if (place.first == kNone) return;
        const std::vector<std::uint32_t>& texels = scene_.images[i].texels;
        std::uint32_t* out = arrays_.texels.data() + place.first;
        for (std::size_t t = 0; t < texels.size(); ++t) out[t * place.stride] = texels[t];
    });
}

}  // namespace vkpt
