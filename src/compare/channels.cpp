#include "compare/channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"

namespace vkpt {
namespace {

std::uint32_t colorsOf(const Image& image) { return image.channels < 3 ? 1 : 3; }
bool hasAlpha(const Image& image) { return image.channels == 2 || image.channels == 4; }

}  // namespace

std::vector<ChannelPair> pairChannels(const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw Error(ExitCode::SizeMismatch, fmt::format("images of {}x{} and {}x{} cannot be compared", image.width,
                                                        image.height, reference.width, reference.height));
    if (image.displayEncoded != reference.displayEncoded)
        throw Error(ExitCode::File, "one image is display-encoded (PNG), the other linear: they cannot be compared");
    constexpr std::array<std::string_view, 3> names{"R", "G", "B"};
    const std::uint32_t colors = std::max(colorsOf(image), colorsOf(reference));
    std::vector<ChannelPair> pairs;
    for (std::uint32_t c = 0; c < colors; ++c)
        pairs.push_back({colors == 1 ? "Y" : names[c], colorsOf(image) == 1 ? 0 : c, colorsOf(reference) == 1 ? 0 : c});
    if (hasAlpha(image) && hasAlpha(reference))
        pairs.push_back({"A", image.channels - 1, reference.channels - 1, false});
    return pairs;
}

}  // namespace vkpt
