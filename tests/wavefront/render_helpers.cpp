#include "wavefront/render_helpers.h"

#include <cstdlib>
#include <cstring>

namespace vkpt {

WavefrontConfig makeConfig() {
    WavefrontConfig config;
    const char* device = getenv("VKPT_TEST_DEVICE");
    config.device = device ? device : "";
    config.validation = true;
    return config;
}

Film renderWith(const SceneArrays& arrays, const RenderOptions& options, const WavefrontConfig& config,
                WavefrontStats* statsOut, const RenderControl& control) {
    WavefrontRenderer renderer(arrays, options, config);
    WavefrontStats stats;
    Film film = renderer.render(control, &stats);
    EXPECT_EQ(stats.validationMessages, 0U);
    EXPECT_EQ(film.refused, 0U);
    if (statsOut) *statsOut = stats;
    return film;
}

std::function<Film(std::uint32_t)> onDevice(const SceneArrays& arrays, const RenderOptions& options) {
    WavefrontConfig config = makeConfig();
    const std::uint64_t paths = std::uint64_t{options.params.width} * options.params.height * options.sampleEnd;
    config.pathsInFlight = static_cast<std::uint32_t>(std::min<std::uint64_t>(paths, 1U << 18U));
    return [renderer = std::make_shared<WavefrontRenderer>(arrays, options, config), options](std::uint32_t seed) {
        renderer->select(seed, options.sampleBegin, options.sampleEnd);
        Film film = renderer->render({});
        EXPECT_EQ(film.refused, 0U);
        EXPECT_EQ(renderer->validationMessages(), 0U);
        return film;
    };
}

bool isSame(const Film& a, const Film& b) {
    return a.width == b.width && a.height == b.height && a.ranges == b.ranges && a.sums.size() == b.sums.size() &&
           std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(FilmSums)) == 0 && a.layers == b.layers;
}

double divergedShare(const Film& a, const Film& b) {
    const Image x = filmToImage(a), y = filmToImage(b);
    int diverged = 0;
    for (std::size_t i = 0; i < x.pixels.size(); i += 4) {
        bool differs = false;
        for (std::size_t c = 0; c < 4; ++c)
            differs |= std::abs(x.pixels[i + c] - y.pixels[i + c]) > 1e-3F * std::max(std::abs(y.pixels[i + c]), 1e-3F);
        diverged += differs ? 1 : 0;
    }
    return 4.0 * diverged / static_cast<double>(x.pixels.size());
}

}  // namespace vkpt
