// The film's layers: both renderers gather the same, whatever the batches, and the picture does not notice.
#include "bvh/build.h"
#include "reference/render.h"
#include "verify/inputs/scenes.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

RenderOptions layeredOptions(std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    RenderOptions options = makeOptions(width, height, samples);
    options.aovs = kAllAovs;
    options.params.backgroundMode = kBackgroundTransparent;
    return options;
}

TEST(RendererLayers, LeaveThePictureAsItIs) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = layeredOptions(48, 32, 4);
    const Film layered = renderWith(arrays, options);
    options.aovs = {};
    const Film plain = renderWith(arrays, options);
    for (std::size_t i = 0; i < plain.sums.size(); ++i) {
        ASSERT_EQ(layered.sums[i].red, plain.sums[i].red);
        ASSERT_EQ(layered.sums[i].green, plain.sums[i].green);
        ASSERT_EQ(layered.sums[i].blue, plain.sums[i].blue);
    }
    EXPECT_TRUE(plain.layers.empty());
}

TEST(RendererLayers, SlotsBatchesAndRangesDoNotChangeThem) {
    const SceneArrays arrays = makeEverything(true);
    RenderOptions options = layeredOptions(24, 20, 6);
    const Film film = renderWith(arrays, options);
    ASSERT_EQ(film.layers.size(), 24U * 20 * film.layout.words());
    for (const std::uint32_t paths : {64U, 1000U}) {
        WavefrontConfig config = makeConfig();
        config.pathsInFlight = paths;
        EXPECT_TRUE(isSame(film, renderWith(arrays, options, config))) << paths;
    }
    Film sum(24, 20, kAllAovs);
    WavefrontRenderer renderer(arrays, options, makeConfig());
    for (const SampleRange range : {SampleRange{4, 6}, SampleRange{0, 1}, SampleRange{1, 4}}) {  // the first not first
        renderer.select(options.params.seed, range.begin, range.end);
        addFilm(sum, renderer.render({}));
    }
    EXPECT_TRUE(isSame(film, sum));
}

/// Pixels of which a word of a layer is off by more than `tolerance`, absolute, a sample.
struct LayerDifference {
    std::size_t pixels = 0, ids = 0;
};

double signedValue(const glm::uvec4& word) {
    const double magnitude = word.z * 65536.0 + word.y * 0x1p-16 + word.x * 0x1p-48;
    return (word.z >> 31U) != 0 ? magnitude - 0x1p48 : magnitude;
}

LayerDifference differ(const Film& a, const Film& b, double tolerance) {
    LayerDifference d;
    const std::size_t words = a.layout.words(), ids = a.layout.firstWord(Layer::Ids),
                      luminance = a.layout.firstWord(Layer::Luminance);
    for (std::size_t pixel = 0; pixel < a.sums.size(); ++pixel) {
        bool off = false;
        for (std::size_t w = 0; w < luminance; ++w) {
            const glm::uvec4 &x = a.layers[pixel * words + w], &y = b.layers[pixel * words + w];
            if (w == ids) {
                d.ids += x != y ? 1 : 0;
            } else {
                off |= std::abs(signedValue(x) - signedValue(y)) > tolerance * a.samples();
            }
        }
        d.pixels += off ? 1 : 0;
    }
    return d;
}

TEST(RendererLayers, EqualTheReferencesUpToRounding) {
    for (const bool instances : {false, true}) {
        SCOPED_TRACE(instances ? "instanced" : "baked");
        const SceneArrays arrays = makeEverything(instances);
        const RenderOptions options = layeredOptions(64, 48, 2);
        const Film device = renderWith(arrays, options), reference = renderReference(arrays, options);
        std::uint32_t surfaces = 0;
        for (std::size_t i = 0; i < device.sums.size(); ++i) {
            ASSERT_EQ(device.sums[i].green.w, reference.sums[i].green.w) << "surfaces met in pixel " << i;
            surfaces += device.sums[i].green.w;
        }
        EXPECT_TRUE(surfaces > 64 * 48 / 2 && surfaces < 64 * 48 * 2) << "the view must show surfaces and sky";
        const LayerDifference d = differ(device, reference, 2e-5);
        EXPECT_EQ(d.ids, 0U);
        EXPECT_LE(d.pixels, 64U * 48 / 200);
    }
}

TEST(RendererLayers, NormalMapsAndUvsToo) {
    const SceneArrays arrays = makeArrays(makePatches());
    RenderOptions options = layeredOptions(64, 48, 1);
    const Film device = renderWith(arrays, options), reference = renderReference(arrays, options);
    const LayerDifference d = differ(device, reference, 1e-4);
    EXPECT_EQ(d.ids, 0U);
    EXPECT_LE(d.pixels, 64U * 48 / 100);
}

/// What the path's luminance is by the exact sums of a film of one sample.
std::uint64_t luminanceOf(const FilmSums& path) {
    __extension__ using Wide = unsigned __int128;
    const auto channel = [](const glm::uvec4& c) { return (Wide{c.z} << 64 | Wide{c.y} << 32 | Wide{c.x}) >> 24; };
    return static_cast<std::uint64_t>(
        (channel(path.red) * 13933 + channel(path.green) * 46871 + channel(path.blue) * 4732 + 32768) >> 16);
}

TEST(RendererLayers, SquaresOfPathLuminanceAreExact) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = layeredOptions(24, 20, 5);
    const std::size_t words = FilmLayout(kAllAovs).words(), at = FilmLayout(kAllAovs).firstWord(Layer::Luminance);
    Film sum(24, 20, kAllAovs);
    WavefrontRenderer renderer(arrays, options, makeConfig());
    for (std::uint32_t s = 0; s < 5; ++s) {
        renderer.select(options.params.seed, s, s + 1);
        const Film one = renderer.render({});
        for (std::size_t i = 0; i < one.sums.size(); ++i) {
            __extension__ using Wide = unsigned __int128;
            const std::uint64_t luminance = luminanceOf(one.sums[i]);
            const Wide square = Wide{luminance} * luminance;
            const glm::uvec4 first(luminance, luminance >> 32U, 0, 0);
            const glm::uvec4 second(square, square >> 32U, square >> 64U, square >> 96U);
            ASSERT_EQ(one.layers[i * words + at], first);
            ASSERT_EQ(one.layers[i * words + at + 1], second);
        }
        addFilm(sum, one);
    }
    renderer.select(options.params.seed, 0, 5);
    EXPECT_TRUE(isSame(sum, renderer.render({})));
}

}  // namespace
}  // namespace vkpt
