// What stands where on a contact sheet.
#include "film/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vkpt {
namespace {

Image plain(std::uint32_t width, std::uint32_t height, std::uint32_t channels, float value) {
    Image image(width, height, channels);
    image.pixels.assign(image.pixels.size(), value);
    return image;
}

constexpr Display kClipped{.toneMap = ToneMap::None};

TEST(ContactSheet, ShowsLayersInTheirOrderAndThenTheirSum) {
    const float values[] = {0.1F, 0.3F};
    std::vector<LightImage> layers;
    for (const float v : values) layers.push_back({"name", "label", plain(240, 60, 3, v), v});
    const Image sheet = contactSheet(layers, plain(240, 60, 4, 0.4F), kClipped);
    ASSERT_EQ(sheet.channels, 3U);
    EXPECT_TRUE(sheet.displayEncoded);
    std::vector<float> met;  // in the order of reading
    for (std::uint32_t y = 0; y < sheet.height; ++y)
        for (std::uint32_t x = 0; x < sheet.width; ++x) {
            const float v = sheet.at(x, y)[1];
            for (const float expected : {0.1F, 0.3F, 0.4F})
                if (v == srgbEncode(expected) && std::ranges::find(met, expected) == met.end()) met.push_back(expected);
        }
    EXPECT_EQ(met, (std::vector<float>{0.1F, 0.3F, 0.4F}));
    const auto tilePixels = std::count(sheet.pixels.begin(), sheet.pixels.end(), srgbEncode(0.3F)) / 3;
    EXPECT_EQ(tilePixels, 240 * 60);
}

TEST(ContactSheet, TilesAreMeansOfBlocks) {
    Image image(960, 4, 3);
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 960; x += 2) std::fill_n(image.at(x, y), 3, 0.5F);
    const Image sheet = contactSheet({{"name", "label", image, 1}}, plain(960, 4, 4, 0), kClipped);
    EXPECT_EQ(std::count(sheet.pixels.begin(), sheet.pixels.end(), srgbEncode(0.25F)) / 3, 480 * 2);
}

TEST(ContactSheet, FramesOfAnyShapeAndNamesOfAnyLengthFindRoom) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(1, 60000), glm::uvec2(60000, 1), glm::uvec2(24, 16)}) {
        const LightImage layer{"name", std::string(1 << 16, 'x'), plain(size.x, size.y, 3, 1), 1};
        const Image sheet = contactSheet(std::vector(65, layer), plain(size.x, size.y, 4, 1), kClipped);
        EXPECT_LT(std::size_t{sheet.width} * sheet.height, 16000000U) << size.x << 'x' << size.y;
    }
}

}  // namespace
}  // namespace vkpt
