// Points, projections, and the table of radical inverses.
#include <fmt/format.h>

#include <array>

#include "analysis/point_pictures.h"
#include "analysis/studies.h"

namespace vkpt {
namespace {

constexpr std::size_t kPanelsARow = 4;

Json pointsJson(const StudiedSampler& sampler, const StudyRequest& request, const PointSet& points) {
    Json list = Json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Json point = Json::array();
        for (std::size_t d = 0; d < points.dims; ++d) point.push_back(points.at(i, d));
        list.push_back(std::move(point));
    }
    Json dimensions = sampler.choice ? Json(request.dimensions) : Json::array({0, 1});
    return {{"sampler", sampler.name},
            {"count", points.size()},
            {"seed", request.seed},
            {"dims", dimensions},
            {"points", std::move(list)}};
}

std::string pointsTable(const StudiedSampler& sampler, const PointSet& points) {
    std::string table = fmt::format("{}: {} points\n", sampler.name, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        table += fmt::format("{:>6}", i);
        for (std::size_t d = 0; d < points.dims; ++d) table += fmt::format("  {:.8f}", points.at(i, d));
        table += '\n';
    }
    return table;
}

/// "0.1101" in the base.
std::string fraction(const std::string& digits) { return "0." + digits; }

}  // namespace

std::uint32_t StudiedSampler::roundedCount(std::uint32_t count) const {
    return choice ? sampleCount(choice->id, count) : count;
}

PointSet StudiedSampler::points(std::uint32_t count, const std::vector<std::uint32_t>& dimensions,
                                std::uint32_t seed) const {
    return choice ? samplePoints(*choice, roundedCount(count), dimensions, seed) : poissonDisk(count, seed);
}

Study studyPoints(const StudyRequest& request) {
    Study study{Json::array(), {}, {}};
    PanelSheet sheet(request.samplers.size(), 260, kPanelsARow);
    for (std::size_t i = 0; i < request.samplers.size(); ++i) {
        const StudiedSampler& sampler = request.samplers[i];
        const PointSet points = sampler.points(request.count, request.dimensions, request.seed);
        study.json.push_back(pointsJson(sampler, request, points));
        study.table += pointsTable(sampler, points);
        if (request.grid)
            drawStrata(sheet.drawing, sheet.panels[i], sampler, static_cast<std::uint32_t>(points.size()));
        if (points.dims > 1)
            drawPoints(sheet.drawing, sheet.panels[i], fmt::format("{}, {} points", sampler.name, points.size()),
                       points);
    }
    study.drawing = std::move(sheet.drawing);
    return study;
}

Study studyProjections(const StudyRequest& request) {
    Study study{Json::array(), {}, {}};
    const std::size_t dims = request.dimensions.size();
    constexpr double kSide = 150, kStep = 180;
    study.drawing.width = 24 + static_cast<double>(dims - 1) * kStep;
    for (const StudiedSampler& sampler : request.samplers) {
        const PointSet points = sampler.points(request.count, request.dimensions, request.seed);
        study.json.push_back(pointsJson(sampler, request, points));
        const double top = study.drawing.height + 34;
        study.drawing.text(16, top - 8, fmt::format("{}, {} points", sampler.name, points.size()), 15);
        for (std::size_t y = 1; y < dims; ++y)
            for (std::size_t x = 0; x < y; ++x) {
                const Panel panel{16 + static_cast<double>(x) * kStep, top + 20 + static_cast<double>(y - 1) * kStep,
                                  kSide};
                drawPoints(study.drawing, panel, fmt::format("({},{})", request.dimensions[x], request.dimensions[y]),
                           points, x, y);
            }
        study.table += pointsTable(sampler, points);
        study.drawing.height = top + 20 + static_cast<double>(dims - 1) * kStep;
    }
    return study;
}

Study studyRadicalInverse(std::uint32_t base, std::uint32_t count) {
    constexpr std::string_view kDigits = "0123456789abcdefghijklmnopqrstuvwxyz";
    Study study{{{"base", base}, {"rows", Json::array()}}, {}, {}};
    constexpr double kColumns[] = {50, 150, 250, 360, 450};  // right edges
    study.drawing = {480, 60 + 18.0 * count, {}};
    study.drawing.text(20, 26, fmt::format("n in base {}, its digits from the lowest, its radical inverse", base), 14);
    const auto addRow = [&](double y, const std::array<std::string, 5>& cells) {
        study.table +=
            fmt::format("{:>6}  {:>12}  {:>12}  {:>14}  {}\n", cells[0], cells[1], cells[2], cells[3], cells[4]);
        for (std::size_t i = 0; i < cells.size(); ++i) study.drawing.text(kColumns[i], y, cells[i], 12, Align::Right);
    };
    addRow(50, {"n", fmt::format("base {}", base), "d1 d2 ...", "inverse", "value"});
    for (std::uint32_t n = 1; n <= count; ++n) {
        std::string digits;  // the lowest first: as they follow the point
        std::uint64_t numerator = 0, denominator = 1;
        for (std::uint32_t rest = n; rest != 0; rest /= base) {
            digits += kDigits[rest % base];
            numerator = numerator * base + rest % base;
            denominator *= base;
        }
        const std::string number(digits.rbegin(), digits.rend());
        const std::string value = fmt::format("{}/{}", numerator, denominator);
        study.json["rows"].push_back({{"n", n},
                                      {"number", number},
                                      {"digits", digits},
                                      {"inverse", fraction(digits)},
                                      {"numerator", numerator},
                                      {"denominator", denominator}});
        addRow(50 + 18.0 * n, {std::to_string(n), number, digits, fraction(digits), value});
    }
    return study;
}

}  // namespace vkpt
