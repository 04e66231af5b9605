#include "film/film.h"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "base/error.h"
#include "constants.h"

namespace vkpt {
namespace {

__extension__ using U128 = unsigned __int128;

int leadingZeros(U128 value) {
    const auto high = static_cast<std::uint64_t>(value >> 64U), low = static_cast<std::uint64_t>(value);
    return high != 0 ? std::countl_zero(high) : 64 + std::countl_zero(low);
}

/// numerator / (denominator x 2^fractionBits), rounded once, to nearest even.
/// The quotient of integers is cut to 32 bits with every lost bit kept as a sticky one; 32 > 24 + 2, so the
/// conversion to float rounds as the exact quotient would. No result is subnormal: the least is 2^-80.
float exactRatio(U128 numerator, std::uint32_t denominator, std::uint32_t fractionBits) {
    if (numerator == 0) return 0.0F;
    const int normalise = leadingZeros(numerator);
    const U128 shifted = numerator << static_cast<unsigned>(normalise);
    const U128 quotient = shifted / denominator;
    const int cut = 96 - leadingZeros(quotient);  // at least 64: the quotient has 96 bits or more
    const bool lost =
        quotient * denominator != shifted || (quotient & ((U128{1} << static_cast<unsigned>(cut)) - 1)) != 0;
    const auto top = static_cast<std::uint32_t>(quotient >> static_cast<unsigned>(cut)) | (lost ? 1U : 0U);
    return std::ldexp(static_cast<float>(top), cut - normalise - static_cast<int>(fractionBits));
}

U128 wide(const uvec4& channel) { return U128{channel.x} | (U128{channel.y} << 32U) | (U128{channel.z} << 64U); }

/// Adds the three low words with carry; w is a plain count of its own.
void addChannel(uvec4& into, const uvec4& other) {
    const U128 sum = wide(into) + wide(other);
    into.x = static_cast<std::uint32_t>(sum);
    into.y = static_cast<std::uint32_t>(sum >> 32U);
    into.z = static_cast<std::uint32_t>(sum >> 64U);
    into.w += other.w;
}

}  // namespace

Image filmToImage(const Film& film) {
    assert(film.sums.size() == std::size_t{film.width} * film.height);
    Image image(film.width, film.height, 4);
    const std::uint32_t samples = film.samples();
    if (samples == 0) return image;
    float* pixel = image.pixels.data();
    for (const FilmSums& sums : film.sums) {
        pixel[0] = exactRatio(wide(sums.red), samples, kFilmFractionBits);
        pixel[1] = exactRatio(wide(sums.green), samples, kFilmFractionBits);
        pixel[2] = exactRatio(wide(sums.blue), samples, kFilmFractionBits);
        pixel[3] = exactRatio(sums.red.w, samples, 0);
        pixel += 4;
    }
    return image;
}

void addFilm(Film& into, const Film& other) {
    if (into.width != other.width || into.height != other.height)
        throw Error(ExitCode::SizeMismatch, fmt::format("films of {}x{} and {}x{} cannot be added", into.width,
                                                        into.height, other.width, other.height));
    if (into.sampleEnd != other.sampleBegin && other.sampleEnd != into.sampleBegin)
        throw Error(ExitCode::Usage, fmt::format("sample ranges {}:{} and {}:{} do not adjoin", into.sampleBegin,
                                                 into.sampleEnd, other.sampleBegin, other.sampleEnd));
    for (std::size_t i = 0; i < into.sums.size(); ++i) {
        addChannel(into.sums[i].red, other.sums[i].red);
        addChannel(into.sums[i].green, other.sums[i].green);
        addChannel(into.sums[i].blue, other.sums[i].blue);
    }
    into.sampleBegin = std::min(into.sampleBegin, other.sampleBegin);
    into.sampleEnd = std::max(into.sampleEnd, other.sampleEnd);
    into.refused += other.refused;
}

}  // namespace vkpt
