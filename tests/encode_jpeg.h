// JPEG files, for tests of what reads them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>
// jpeglib.h needs stdio's types.
#include <jpeglib.h>

namespace vkpt {

/// `samples` of `channels` a pixel in `space`, at quality 100.
[[nodiscard]] inline std::vector<std::uint8_t> encodeJpeg(std::uint32_t width, std::uint32_t height, int channels,
                                                          J_COLOR_SPACE space, const std::vector<std::uint8_t>& samples,
                                                          bool progressive = false) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &data, &size);
    info.image_width = width;
    info.image_height = height;
    info.input_components = channels;
    info.in_color_space = space;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 100, TRUE);
    if (progressive) jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    while (info.next_scanline < height) {
        auto* row = const_cast<JSAMPROW>(samples.data() +
                                         std::size_t{info.next_scanline} * width * static_cast<unsigned>(channels));
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    std::vector<std::uint8_t> out(data, data + size);
    jpeg_destroy_compress(&info);
    std::free(data);
    return out;
}

}  // namespace vkpt
