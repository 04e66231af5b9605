// A look at an OpenEXR file's headers before its library reads them.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace vkpt {

/// A data window of up to so many pixels needs no proof; a larger one a byte of the file for kExrPixelsPerByte of them
/// (plain black under the strongest compression takes more).
inline constexpr std::uint64_t kExrFreePixels = std::uint64_t{1} << 22U, kExrPixelsPerByte = 8192;

/// The library allocates what headers ask for before it knows that the file holds it. Throws FileError where an
/// attribute, a data window or a table of chunks of any part cannot be in a file of this size.
void checkExrHeaders(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace vkpt
