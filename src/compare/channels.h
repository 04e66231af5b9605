// Which channels of two images face each other.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace vkpt {

/// One compared channel: its index in the pixels of each image.
struct ChannelPair {
    std::string_view name;  ///< "R", "G", "B", "Y" or "A"
    std::uint32_t image = 0, reference = 0;
    bool isColor = true;  ///< false: alpha
};

/// One or two channels are grey (and alpha), three or four RGB (and alpha). A grey image faces each colour of an RGB
/// one. Alpha comes last, where both have it. Throws Error(SizeMismatch) where the sizes differ, Error(File) where one
/// image is linear and the other display-encoded.
[[nodiscard]] std::vector<ChannelPair> pairChannels(const Image& image, const Image& reference);

}  // namespace vkpt
