#include "analysis/environment_study.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include "analysis/environment_pictures.h"
#include "base/error.h"
#include "base/math.h"
#include "reference/lights/environment.h"

namespace vkpt {
namespace {

struct LightIntegral {
    const char* name;
    const char* unit;
    glm::dvec3 normal;  ///< of the surface that is lit; 0: light counts from everywhere alike
};
constexpr std::array<LightIntegral, 3> kLightIntegrals{{{"light from everywhere", "nits sr", {0, 0, 0}},
                                                        {"irradiance from above", "lux", {0, 1, 0}},
                                                        {"irradiance from -z", "lux", {0, 0, -1}}}};

/// Of one integrand: the integral, that of its square, and that of its square over the density.
struct Sums {
    double value = 0, square = 0, squareOverPdf = 0;

    void add(const Sums& s) {
        value += s.value;
        square += s.square;
        squareOverPdf += s.squareOverPdf;
    }
    /// Variance of one sample of a uniform direction, and of one by importance, relative to the squared integral.
    [[nodiscard]] double uniformVariance() const { return relative(4 * std::numbers::pi * square); }
    [[nodiscard]] double importanceVariance() const { return relative(squareOverPdf); }

private:
    /// What the quadrature leaves of 0 is 0.
    [[nodiscard]] double relative(double secondMoment) const {
        const double variance = secondMoment / (value * value) - 1;
        return variance < 1e-6 ? 0 : variance;
    }
};

struct Measures {
    double pdf = 0;  ///< integral of the density: 1
    std::array<Sums, kLightIntegrals.size()> sums;

    void add(const Measures& m) {
        pdf += m.pdf;
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(m.sums[i]);
    }
};

/// Points of the quadrature in a texel, along one side: enough for small maps, too.
std::uint32_t pointsOf(std::uint32_t texels) { return std::max(2U, 512 / texels); }

/// Quadrature over a row of texels: radiance and density as renderers look them up.
Measures measureRow(const reference::Environment& environment, std::uint32_t row, std::uint32_t width,
                    std::uint32_t height) {
    const std::uint32_t rows = pointsOf(height), columns = width * pointsOf(width);
    Measures m;
    for (std::uint32_t y = rows * row; y < rows * (row + 1); ++y) {
        const double top = std::cos(std::numbers::pi * y / (rows * height)),
                     bottom = std::cos(std::numbers::pi * (y + 1) / (rows * height));
        const double solidAngle = (top - bottom) * 2 * std::numbers::pi / columns;
        for (std::uint32_t x = 0; x < columns; ++x) {
            const glm::vec3 d = reference::environmentDirection(static_cast<float>((x + 0.5) / columns),
                                                                static_cast<float>((top + bottom) / 2));
            const double light = double{luminance(environment.radiance(d))}, pdf = double{environment.pdf(d)};
            m.pdf += pdf * solidAngle;
            for (std::size_t i = 0; i < kLightIntegrals.size(); ++i) {
                const glm::dvec3& n = kLightIntegrals[i].normal;
                const double f = light * (n == glm::dvec3(0) ? 1 : std::max(0.0, glm::dot(n, glm::dvec3(d))));
                if (f == 0) continue;
                m.sums[i].value += f * solidAngle;
                m.sums[i].square += f * f * solidAngle;
                m.sums[i].squareOverPdf += pdf > 0 ? f * f / pdf * solidAngle : INFINITY;
            }
        }
    }
    return m;
}

Measures measure(const SceneArrays& arrays, const reference::Environment& environment,
                 const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
    const std::uint64_t width = arrays.envWidth, height = arrays.envHeight;
    std::vector<Measures> rows(height);
    std::uint64_t done = 0;
    std::mutex telling;
    if (progress) progress(0, width * height);
    tbb::parallel_for(std::uint32_t{0}, arrays.envHeight, [&](std::uint32_t row) {
        rows[row] = measureRow(environment, row, arrays.envWidth, arrays.envHeight);
        const std::scoped_lock lock(telling);
        ++done;
        if (progress) progress(width * done, width * height);
    });
    Measures whole;
    for (const Measures& row : rows) whole.add(row);
    return whole;
}

/// (u, v) of the map, from 0 to 1, of the directions that are drawn.
std::vector<glm::dvec2> drawPlaces(const reference::Environment& environment, const EnvironmentStudyRequest& request) {
    const PointSet points = samplePoints(request.sampler, request.count, {0, 1}, request.seed);
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 u(std::min(static_cast<float>(points.at(i, 0)), 1 - 0x1p-24F),
                          std::min(static_cast<float>(points.at(i, 1)), 1 - 0x1p-24F));
        places.emplace_back(reference::environmentUv(glm::dvec3(environment.sample(u).direction)));
    }
    return places;
}

std::string tableOf(const EnvironmentStudyRequest& request, const Measures& m) {
    std::string table =
        fmt::format("{}: {}x{}, mean luminance {:.4g} nits, integral of the density {:.6f}\n\n", request.name,
                    request.map.width, request.map.height, m.sums[0].value / (4 * std::numbers::pi), m.pdf);
    table += fmt::format("{:<24}{:>12} {:<10}{:>10}{:>12}{:>10}\n", "variance of one sample", "value", "", "uniform",
                         "importance", "ratio");
    for (std::size_t i = 0; i < kLightIntegrals.size(); ++i) {
        const Sums& s = m.sums[i];
        if (s.value == 0) continue;
        const double by = s.importanceVariance();
        const std::string ratio = by > 0 ? fmt::format("{:.4g}", s.uniformVariance() / by) : "-";
        table += fmt::format("{:<24}{:>12.5g} {:<10}{:>10.4g}{:>12.4g}{:>10}\n", kLightIntegrals[i].name, s.value,
                             kLightIntegrals[i].unit, s.uniformVariance(), by, ratio);
    }
    return table + "\nVariances are relative to the value squared, by quadrature over 2 x 2 or more points a texel.\n";
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json jsonOf(const EnvironmentStudyRequest& request, const SceneArrays& arrays, const Measures& m,
            const std::vector<glm::dvec2>& places) {
    Json json{{"environment", request.name},  {"width", request.map.width},
              {"height", request.map.height}, {"meanLuminance", m.sums[0].value / (4 * std::numbers::pi)},
              {"densityIntegral", m.pdf},     {"integrals", Json::array()},
              {"marginalCdf", Json::array()}, {"samples", Json::array()}};
    for (std::size_t i = 0; i < kLightIntegrals.size(); ++i)
        json["integrals"].push_back({{"name", kLightIntegrals[i].name},
                                     {"value", m.sums[i].value},
                                     {"uniformVariance", finite(m.sums[i].uniformVariance())},
                                     {"importanceVariance", finite(m.sums[i].importanceVariance())}});
    for (std::uint32_t row = 0; row < arrays.envHeight; ++row) json["marginalCdf"].push_back(arrays.envRows[row]);
    for (const glm::dvec2& place : places) json["samples"].push_back({place.x, place.y});
    return json;
}

}  // namespace

Study studyEnvironment(const EnvironmentStudyRequest& request) {
    SceneArrays arrays;
    addEnvironment(arrays, request.map, 1, 0);
    if (!arrays.features.environment)
        throw Error(ExitCode::Usage, request.name + ": is black: there is nothing to draw from");
    const reference::Environment environment(arrays);
    const Measures measures = measure(arrays, environment, request.progress);
    const auto places = drawPlaces(environment, request);
    Study study{jsonOf(request, arrays, measures, places), tableOf(request, measures), {}};
    if (request.picture) study.drawing = drawEnvironment(request.name, arrays, places);
    return study;
}

}  // namespace vkpt
