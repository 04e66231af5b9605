// What `vkpt env` says of maps whose answers are known.
#include "analysis/environment_study.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/error.h"

namespace vkpt {
namespace {

Study studyOf(EnvironmentMap map, std::uint32_t count = 64) {
    return studyEnvironment({"map", std::move(map), SamplerChoice(SamplerId::Sobol), count, 0, true, {}});
}

/// Speckles of a small map, black ones among them.
EnvironmentMap speckles(std::uint32_t width, std::uint32_t height) {
    EnvironmentMap map{width, height, {}};
    std::mt19937 generator(5);
    for (std::uint32_t i = 0; i < width * height; ++i)
        map.texels.emplace_back(generator() % 3 == 0 ? 0.0F : static_cast<float>(generator() % 1000) / 100);
    return map;
}

double number(const Study& study, int integral, const char* key) {
    return study.json.at("integrals").at(static_cast<std::size_t>(integral)).at(key).get<double>();
}

// Under an even sky a uniform direction is all there is to draw: cos+ has variance 4 pi (2 pi / 3) / pi^2 - 1.
TEST(EnvironmentStudy, OfAnEvenSkyIsKnown) {
    const Study study = studyOf(constantEnvironment(glm::vec3(2)));
    EXPECT_NEAR(number(study, 0, "value"), 8 * std::numbers::pi, 1e-4);
    EXPECT_EQ(number(study, 0, "uniformVariance"), 0);
    EXPECT_EQ(number(study, 0, "importanceVariance"), 0);
    for (const int i : {1, 2}) {
        EXPECT_NEAR(number(study, i, "value"), 2 * std::numbers::pi, 1e-3);
        EXPECT_NEAR(number(study, i, "uniformVariance"), 5.0 / 3, 1e-3);
        EXPECT_NEAR(number(study, i, "importanceVariance"), 5.0 / 3, 1e-3);
    }
}

// Looked up as renderers do, over every map the density adds up to 1, its cells those of the bilinear lookup.
TEST(EnvironmentStudy, DensityIntegratesToOne) {
    for (const auto& [width, height] : {std::pair{5U, 3U}, {1U, 7U}, {16U, 8U}, {64U, 33U}})
        EXPECT_NEAR(studyOf(speckles(width, height)).json.at("densityIntegral").get<double>(), 1, 1e-5)
            << width << 'x' << height;
}

TEST(EnvironmentStudy, ImportanceGainsMostWhereLightIsSmall) {
    EnvironmentMap sun{64, 32, std::vector<glm::vec3>(std::size_t{64} * 32, glm::vec3(0.01F))};
    sun.texels[5 * 64 + 20] = glm::vec3(1e4F);
    const Study study = studyOf(sun, 512);
    EXPECT_GT(number(study, 1, "uniformVariance"), 500);
    EXPECT_LT(number(study, 1, "importanceVariance"), 2);
    int near = 0;  // the bilinear lookup spreads the sun over its neighbours
    for (const Json& place : study.json.at("samples"))
        near += std::abs(place.at(0).get<double>() - 20.5 / 64) < 1.6 / 64 &&
                std::abs(place.at(1).get<double>() - 5.5 / 32) < 1.6 / 32;
    EXPECT_GT(near, 500);
    EXPECT_EQ(study.json.at("marginalCdf").size(), 32U);
    EXPECT_EQ(study.json.at("marginalCdf").at(31).get<float>(), 1);
    EXPECT_GT(study.drawing.shapes.size(), 600U);
}

/// The picture that follows the title which begins so; empty where there is none before the next text.
Image pictureUnder(const Drawing& drawing, const std::string& title) {
    bool under = false;
    for (const Shape& shape : drawing.shapes) {
        if (const auto* text = std::get_if<shape::Text>(&shape)) under = text->text.starts_with(title);
        if (const auto* picture = std::get_if<shape::Picture>(&shape); picture && under) return picture->image;
    }
    return {};
}

// Rows that are multiples of one another have one conditional density, whatever their share of the marginal.
TEST(EnvironmentStudy, ShowsTheConditionalDensityOfEachRow) {
    constexpr std::uint32_t kWidth = 16, kHeight = 8;
    EnvironmentMap map{kWidth, kHeight, {}};
    for (std::uint32_t j = 0; j < kHeight; ++j)
        for (std::uint32_t i = 0; i < kWidth; ++i)
            map.texels.emplace_back(static_cast<float>((j + 1) * (j + 1)) * static_cast<float>(i + 1));
    const Drawing drawing = studyOf(map).drawing;
    const Image importance = pictureUnder(drawing, "scalar importance"),
                conditional = pictureUnder(drawing, "conditional density");
    ASSERT_EQ(importance.pixels.size(), 3 * kWidth * kHeight);
    ASSERT_EQ(conditional.pixels.size(), 3 * kWidth * kHeight);
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i)
        EXPECT_NEAR(*conditional.at(i % kWidth, i / kWidth), *conditional.at(i % kWidth, 0), 1e-4) << i;
    EXPECT_GT(std::abs(*importance.at(0, 0) - *importance.at(0, kHeight / 2)), 0.1);
}

TEST(EnvironmentStudy, PicturesShowTheSphereWhateverTheShapeOfTheMap) {
    const Drawing usual = studyOf(speckles(16, 8)).drawing;
    for (const auto& [width, height] : {std::pair{1U, 1U}, {1U, 512U}, {512U, 1U}, {5U, 3U}}) {
        const Drawing drawing = studyOf(speckles(width, height)).drawing;
        EXPECT_EQ(drawing.width, usual.width);
        EXPECT_EQ(drawing.height, usual.height) << width << 'x' << height;
    }
}

// Noise is what PNG packs least.
TEST(EnvironmentStudy, SvgHoldsOneImageAMapAndStaysSmall) {
    const std::string svg = toSvg(studyOf(speckles(320, 160)).drawing);
    std::size_t images = 0;
    for (std::size_t at = svg.find("<image "); at != std::string::npos; at = svg.find("<image ", at + 1)) ++images;
    EXPECT_EQ(images, 4U);
    EXPECT_LT(svg.size(), 1'000'000U);
}

TEST(EnvironmentStudy, TellsOfItsProgressOnceARow) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> told;
    EnvironmentStudyRequest request{"map", speckles(16, 8), SamplerChoice(SamplerId::Sobol), 64, 0, false, {}};
    request.progress = [&](std::uint64_t done, std::uint64_t total) { told.emplace_back(done, total); };
    (void)studyEnvironment(request);
    ASSERT_EQ(told.size(), 9U);
    for (std::uint64_t row = 0; row <= 8; ++row) EXPECT_EQ(told[row], std::pair(16 * row, std::uint64_t{128}));
}

TEST(EnvironmentStudy, ABlackMapIsRefused) { EXPECT_THROW((void)studyOf(constantEnvironment(glm::vec3(0))), Error); }

}  // namespace
}  // namespace vkpt
