// How far one image is from another, value by value.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace vkpt {

/// Keeps dark pixels from deciding the relative errors.
inline constexpr double kRelativeErrorFloor = 0.01;

/// Of one channel, or of several together. a: the image's value, r: the reference's. Means are over the values that
/// are finite in both images, and NaN where there is none.
struct ErrorFigures {
    std::uint64_t values = 0;    ///< finite in both images
    double meanAbsolute = 0;     ///< mean of |a - r|
    double meanSquare = 0;       ///< mean of (a - r)^2
    double rootMeanSquare = 0;   ///< its root
    double relativeMse = 0;      ///< mean of (a - r)^2 / (r^2 + kRelativeErrorFloor) [Rousselle 11]
    double mrse = 0;             ///< mean of (a - r)^2 / (|r| + kRelativeErrorFloor)^2
    double psnr = 0;             ///< 10 log10(peak^2 / meanSquare) dB; infinite where nothing differs
    double maximum = 0;          ///< largest |a - r|; infinite where a value is finite in one image only
    std::uint32_t x = 0, y = 0;  ///< where it is
};

struct ChannelFigures : ErrorFigures {
    std::string_view name;  ///< "R", "G", "B", "Y" or "A"
};

/// Values that are NaN or infinite: they take part in no mean.
struct NonFinite {
    std::uint64_t inImage = 0, inReference = 0;
    std::uint64_t differing = 0;  ///< pairs of which one is finite, or that are not NaN or infinite alike
};

/// The figures of the colour channels together; each channel's own, alpha included, in `channels`.
struct ImageDifference : ErrorFigures {
    double peak = 0;  ///< what psnr is relative to
    NonFinite nonFinite;
    std::vector<ChannelFigures> channels;
};

/// `reference` is the image taken as true. `peak`: the largest possible value; empty: 1 for display-encoded images, the
/// largest colour value of the reference for linear ones. Channels are paired by pairChannels, which may throw.
[[nodiscard]] ImageDifference compareImages(const Image& image, const Image& reference,
                                            std::optional<double> peak = std::nullopt);

}  // namespace vkpt
