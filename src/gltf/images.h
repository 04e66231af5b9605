// PNG and JPEG -> 8-bit RGBA.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "gltf/document.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// Decodes images[index] of the file. Throws FileError where its bytes are missing, no PNG or JPEG, or broken.
[[nodiscard]] TextureImage loadImage(const Document& document, std::size_t index, std::vector<std::string>& warnings);

/// Colours stay as stored (no gamma, no colour profile: glTF ignores both); grey and palette images become RGB;
/// 16-bit samples are rounded to 8. On failure `fault` says why and the image is empty. `fault` may also be set,
/// with an image, by damage that could be worked around.
[[nodiscard]] TextureImage decodePng(std::span<const std::byte> bytes, std::string& fault);
/// CMYK is turned into RGB without a colour profile. As decodePng otherwise.
[[nodiscard]] TextureImage decodeJpeg(std::span<const std::byte> bytes, std::string& fault);

/// Larger images are refused: 2^28 pixels are 1 GiB of RGBA; a texture's width and height are kept in 16 bits.
inline constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 28;
inline constexpr std::uint32_t kMaxImageSide = 65535;

}  // namespace vkpt::gltf
