#include "scene/environment.h"

#include <oneapi/tbb/parallel_for.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/image_read.h"
#include "base/math.h"
#include "scene/flatten_lights.h"
#include "scene/sampling_table.h"

namespace vkpt {
namespace {

constexpr float kBrightest = 1e30F;  // leaves float room for sums

/// Solid angle of one cell of row j.
double cellSolidAngle(std::uint32_t j, std::uint32_t width, std::uint32_t height) {
    const double top = std::cos(std::numbers::pi * j / height),
                 bottom = std::cos(std::numbers::pi * (j + 1.0) / height);
    return 2 * std::numbers::pi / width * (top - bottom);
}

/// Mean over the cell of texel (i, j) of the bilinear interpolant's luminance. Within its own cell a texel's tent has
/// mean 3/4, each neighbour's 1/8, in either axis.
double cellImportance(const std::vector<double>& lum, std::uint32_t i, std::uint32_t j, std::uint32_t width,
                      std::uint32_t height) {
    const std::array<std::size_t, 3> columns{i == 0 ? width - 1 : i - 1, i, i + 1 == width ? 0 : i + 1};
    const std::array<std::size_t, 3> rows{j == 0 ? 0 : j - 1, j, j + 1 == height ? j : j + 1};
    constexpr std::array<double, 3> kWeights{0.125, 0.75, 0.125};
    double sum = 0;
    for (std::size_t y = 0; y < 3; ++y) {
        for (std::size_t x = 0; x < 3; ++x) sum += kWeights[x] * kWeights[y] * lum[rows[y] * width + columns[x]];
    }
    return sum;
}

std::uint32_t padded(std::uint32_t n) { return (n + 3) / 4 * 4; }

void removeEnvironment(SceneArrays& arrays) {
    if (arrays.envLight != kNone) {
        arrays.lights.erase(arrays.lights.begin() + arrays.envLight);
        arrays.lightPower.erase(arrays.lightPower.begin() + arrays.envLight);
    }
    arrays.envTexels.clear();
    arrays.envRows.clear();
    arrays.envColumns.clear();
    arrays.envWidth = arrays.envHeight = 0;
    arrays.envLight = kNone;
    arrays.envRotation = 0;
    arrays.features.environment = false;
    buildLightTable(arrays);
}

/// Fills rows, columns and the pdf of every cell from the texels' rgb. Returns the integral of luminance over the
/// sphere.
double buildTables(SceneArrays& arrays) {
    const std::uint32_t width = arrays.envWidth, height = arrays.envHeight;
    std::vector<double> lum(arrays.envTexels.size());
    std::transform(arrays.envTexels.begin(), arrays.envTexels.end(), lum.begin(),
                   [](const glm::vec4& t) { return double{luminance(glm::vec3(t))}; });

    arrays.envColumns.assign(std::size_t{padded(width)} * height, 1.0F);
    std::vector<double> rowIntegrals(height);
    tbb::parallel_for(std::uint32_t{0}, height, [&](std::uint32_t j) {
        std::vector<double> importance(width);
        for (std::uint32_t i = 0; i < width; ++i) {
            importance[i] = cellImportance(lum, i, j, width, height);
            rowIntegrals[j] += importance[i] * cellSolidAngle(j, width, height);
        }
        const std::vector<float> cdf = inclusiveCdf(importance);
        std::copy(cdf.begin(), cdf.end(), arrays.envColumns.begin() + std::size_t{padded(width)} * j);
    });
    arrays.envRows = inclusiveCdf(rowIntegrals);

    // The pdf is that of the rounded tables, which are what directions are drawn from.
    tbb::parallel_for(std::uint32_t{0}, height, [&](std::uint32_t j) {
        const std::span<const float> cdf(arrays.envColumns.data() + std::size_t{padded(width)} * j, width);
        const double row = cdfStep(arrays.envRows, j) / cellSolidAngle(j, width, height);
        for (std::uint32_t i = 0; i < width; ++i) {
            arrays.envTexels[std::size_t{j} * width + i].w = static_cast<float>(row * double{cdfStep(cdf, i)});
        }
    });
    arrays.envRows.resize(padded(height), 1.0F);
    double integral = 0;
    for (const double row : rowIntegrals) integral += row;
    return integral;
}

}  // namespace

EnvironmentMap readEnvironment(const std::filesystem::path& file) {
    const Image image = readImage(file);
    const bool srgb = file.extension() == ".png" || file.extension() == ".PNG";
    EnvironmentMap map{image.width, image.height, {}};
    map.texels.resize(std::size_t{image.width} * image.height);
    std::size_t repaired = 0;
    for (std::size_t i = 0; i < map.texels.size(); ++i) {
        const float* pixel = image.pixels.data() + i * image.channels;
        for (glm::length_t c = 0; c < 3; ++c) {
            const float value = pixel[image.channels >= 3 ? static_cast<std::uint32_t>(c) : 0U];
            const bool good = value >= 0 && std::isfinite(value);
            repaired += good ? 0 : 1;
            map.texels[i][c] = !good ? 0 : srgb ? srgbToLinear(value) : value;
        }
    }
    if (repaired != 0) {
        spdlog::warn("{}: {} negative or non-finite values were read as 0", file.string(), repaired);
    }
    return map;
}

EnvironmentMap constantEnvironment(const glm::vec3& radiance) { return {1, 1, {radiance}}; }

void addEnvironment(SceneArrays& arrays, const EnvironmentMap& map, float strength, float rotationDegrees) {
    removeEnvironment(arrays);
    arrays.envTexels.resize(map.texels.size());
    std::transform(map.texels.begin(), map.texels.end(), arrays.envTexels.begin(),
                   [&](const glm::vec3& t) { return glm::vec4(glm::min(t * strength, kBrightest), 0); });
    arrays.envWidth = map.width;
    arrays.envHeight = map.height;
    const double integral = buildTables(arrays);
    if (!(integral > 0)) {
        removeEnvironment(arrays);
        return;
    }
    arrays.envRotation = glm::radians(rotationDegrees);
    arrays.features.environment = true;
    arrays.envLight = static_cast<std::uint32_t>(arrays.lights.size());
    LightRecord light{};
    light.kind = kLightEnvironment;
    light.index = kNone;
    arrays.lights.push_back(light);
    const double radius = sceneRadius(arrays);
    arrays.lightPower.push_back(static_cast<float>(std::numbers::pi * radius * radius * integral));
    buildLightTable(arrays);
}

}  // namespace vkpt
