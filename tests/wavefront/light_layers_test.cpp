// Layers of light: the same integers as the picture, sorted by length of path and by light, on both renderers.
#include <cstring>
#include <optional>

#include "bvh/build.h"
#include "film/light_images.h"
#include "film/wide_integer.h"
#include "reference/render.h"
#include "scene/light_groups.h"
#include "wavefront/kernels.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

constexpr U128 kModulus = U128{1} << 96U;

/// Emissive meshes, punctual lights and a sky about a floor and a pane of glass.
SceneArrays litRoom() {
    Scene scene = makeLamps();
    Material glass;
    glass.bsdf = BsdfSpec{.model = BsdfId::Dielectric};
    glass.bsdf->eta = glm::vec3(1.5F);
    scene.materials.push_back(glass);
    const auto index = static_cast<std::uint32_t>(scene.materials.size() - 1);
    addObject(scene, makeQuad({-1, 0.2F, 1}, {2, 0, 0}, {0, 1, 0.1F}, index));
    SceneArrays arrays = flatten(scene);
    finishUnderNoise(arrays, 71);
    groupLights(arrays, {true, {}}, false, "room");
    return arrays;
}

const SceneArrays& room() {
    static const SceneArrays arrays = litRoom();
    return arrays;
}

RenderOptions sorted(std::uint32_t lengths = 6) {
    RenderOptions options = makeOptions(32, 24, 4);
    options.light = {lengths, room().lightGroups.names};
    return options;
}

/// Layers [begin, end) of those from `firstWord` on, added up.
std::array<U128, 3> layersOf(const Film& film, std::size_t pixel, std::uint32_t firstWord, std::size_t begin,
                             std::size_t end) {
    std::array<U128, 3> sum{};
    const uvec4* words = film.layers.data() + pixel * film.layout.words() + firstWord;
    for (std::size_t layer = begin; layer < end; ++layer)
        for (std::size_t c = 0; c < 3; ++c) sum[c] = (sum[c] + sumOf(words[layer * kLightWords + c])) % kModulus;
    return sum;
}

std::array<U128, 3> beautyOf(const Film& film, std::size_t pixel) {
    const FilmSums& s = film.sums[pixel];
    return {sumOf(s.red), sumOf(s.green), sumOf(s.blue)};
}

void expectSumsOfLayers(const Film& film) {
    const LightLayers& light = film.layout.light();
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        ASSERT_EQ(layersOf(film, i, film.layout.lengthWord(), 0, light.lengths), beautyOf(film, i)) << "pixel " << i;
        ASSERT_EQ(layersOf(film, i, film.layout.groupWord(), 0, light.groups.size()), beautyOf(film, i)) << i;
    }
}

/// Of sorted(), rendered once a renderer: kernels take seconds to make where a CPU poses as the device.
const Film& filmOf(bool device) {
    static std::array<std::optional<Film>, 2> films;
    std::optional<Film>& film = films[device ? 1 : 0];
    if (!film) film = device ? renderWith(room(), sorted()) : renderReference(room(), sorted());
    return *film;
}

/// Both renderers.
class LightLayersOn : public testing::TestWithParam<bool> {
protected:
    static Film render(const SceneArrays& arrays, const RenderOptions& options) {
        return GetParam() ? renderWith(arrays, options) : renderReference(arrays, options);
    }
    static const Film& film() { return filmOf(GetParam()); }
};

TEST_P(LightLayersOn, AddUpToThePictureAsIntegersAndLeaveItAsItIs) {
    RenderOptions options = sorted();
    options.light = {};
    const Film plain = render(room(), options);
    EXPECT_TRUE(plain.layers.empty());
    EXPECT_EQ(std::memcmp(plain.sums.data(), film().sums.data(), plain.sums.size() * sizeof(FilmSums)), 0);
    expectSumsOfLayers(film());
    for (const auto& images : {lengthImages(film()), groupImages(film())}) {
        double shares = 0;
        for (const LightImage& image : images) {
            EXPECT_TRUE(image.share > 0 || shares > 0.99) << image.name << " has nothing";
            shares += image.share;
        }
        EXPECT_NEAR(shares, 1, 1e-5);
    }
}

TEST_P(LightLayersOn, AddUpWhateverTheEstimator) {
    RenderOptions options = sorted(3);
    options.params.clampIndirect = 0.05F;
    options.params.pixelFilter = kFilterMitchell;  // takes light away
    options.params.filterRadius = 2;
    options.params.rrMode = kRouletteFixed;
    options.params.rrFixed = 0.7F;
    options.params.backgroundMode = kBackgroundColor;
    options.params.background = {0.1F, 0.2F, 0.3F};
    expectSumsOfLayers(render(room(), options));
}

// Nothing of a path depends on how long it may yet become.
TEST_P(LightLayersOn, TheFirstOfThemAreWhatShallowerPathsSee) {
    for (std::uint32_t depth = 0; depth < (GetParam() ? 1U : 4U); ++depth) {  // of the device's, the emission
        RenderOptions options = sorted();
        options.params.maxDepth = depth;
        const Film shallow = render(room(), options);
        for (std::size_t i = 0; i < shallow.sums.size(); ++i)
            ASSERT_EQ(layersOf(film(), i, film().layout.lengthWord(), 0, depth + 1), beautyOf(shallow, i)) << depth;
    }
}

TEST_P(LightLayersOn, WhatIsRefusedIsInNone) {
    SceneArrays arrays = room();
    for (MaterialRecord& m : arrays.materials)
        if (m.emissive != glm::vec3(0)) m.emissive = glm::vec3(0x1p60F);  // as met; light samples stay as they are
    Film film;
    if (GetParam()) {
        WavefrontRenderer renderer(arrays, sorted(), makeConfig());
        film = renderer.render({});
    } else {
        film = renderReference(arrays, sorted());
    }
    EXPECT_GT(film.refused, 20U);
    expectSumsOfLayers(film);
    double brightest = 0;
    const std::vector<LightImage> images = lengthImages(film);
    for (const float v : images[0].image.pixels) brightest = std::max(brightest, double{v});
    EXPECT_LT(brightest, 2) << "the sky is all that the camera sees shine";
}

INSTANTIATE_TEST_SUITE_P(Renderers, LightLayersOn, testing::Bool(),
                         [](const auto& test) { return test.param ? "vulkan" : "cpu"; });

TEST(LightLayers, OfIntegratorDirectAreTwo) {
    RenderOptions options = sorted(2);
    options.params.integrator = static_cast<std::uint32_t>(IntegratorId::Direct);
    options.params.bsdfSamples = 2;
    options.params.lightSamples = 3;
    const Film direct = renderReference(room(), options);
    expectSumsOfLayers(direct);
    EXPECT_EQ(direct.layout.words(), 3 * (2 + room().lightGroups.names.size()));
}

TEST(LightLayers, TheLastTakesAllLongerPaths) {
    const Film& film = filmOf(false);
    const Film three = renderReference(room(), sorted(3));
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        ASSERT_EQ(layersOf(three, i, 0, 1, 2), layersOf(film, i, 0, 1, 2));
        ASSERT_EQ(layersOf(three, i, 0, 2, 3), layersOf(film, i, 0, 2, 6));
    }
}

TEST(LightLayers, OfShadowRaysWithAStageOfTheirOwnAreTheSame) {
    ASSERT_GT(listTriangles(room(), sorted().params.integrator), 0U) << "shade would not trace them";
    WavefrontConfig config = makeConfig();
    config.fetch = WavefrontConfig::Fetch::Texel;
    const Film inside = renderWith(room(), sorted(), config);
    config.fetch = WavefrontConfig::Fetch::Storage;
    EXPECT_TRUE(isSame(inside, renderWith(room(), sorted(), config)));
}

TEST(LightLayers, RangesSlotsAndBatchesDoNotChangeThem) {
    WavefrontConfig config = makeConfig();
    config.pathsInFlight = 500;
    WavefrontRenderer renderer(room(), sorted(), config);
    Film sum(32, 24, {}, sorted().light);
    for (const SampleRange range : {SampleRange{3, 4}, SampleRange{0, 3}}) {
        renderer.select(sorted().params.seed, range.begin, range.end);
        addFilm(sum, renderer.render({}));
    }
    EXPECT_TRUE(isSame(sum, filmOf(true)));
}

TEST(LightLayers, AreThoseOfTheReference) {
    const Film &device = filmOf(true), &reference = filmOf(false);
    const auto compare = [](const std::vector<LightImage>& a, const std::vector<LightImage>& b) {
        for (std::size_t layer = 0; layer < a.size(); ++layer) {
            std::size_t off = 0;
            for (std::size_t i = 0; i < a[layer].image.pixels.size(); ++i) {
                const float x = a[layer].image.pixels[i], y = b[layer].image.pixels[i];
                off += std::abs(x - y) > 1e-3F * std::max(std::abs(y), 1e-3F) ? 1 : 0;
            }
            EXPECT_LE(off, a[layer].image.pixels.size() / 50) << a[layer].name;
        }
    };
    compare(lengthImages(device), lengthImages(reference));
    compare(groupImages(device), groupImages(reference));
}

}  // namespace
}  // namespace vkpt
