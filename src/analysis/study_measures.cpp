// Discrepancy, spectra and convergence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/convergence.h"
#include "analysis/discrepancy.h"
#include "analysis/point_pictures.h"
#include "analysis/spectrum.h"
#include "analysis/studies.h"
#include "plot/chart.h"

namespace vkpt {
namespace {

/// Points, the box that attains the star discrepancy, and what is wrong with it.
void drawStarBox(Drawing& drawing, const Panel& panel, const std::string& name, const PointSet& points,
                 const StarDiscrepancy& star) {
    const Ink tint{1.0F, 0.93F, 0.85F};
    drawing.box(panel.x, panel.placeY(star.y), star.x * panel.side, star.y * panel.side, tint);
    drawPoints(drawing, panel,
               fmt::format("{}: D* = |{:.3f} - {}/{}| = {:.4f}", name, star.x * star.y, star.inside, points.size(),
                           star.value),
               points);
    drawing.frame(panel.x, panel.placeY(star.y), star.x * panel.side, star.y * panel.side, 1.2, inkOf(1));
}

Json starJson(const StarDiscrepancy& star) {
    return {{"value", star.value},
            {"box", {star.x, star.y}},
            {"boxArea", star.x * star.y},
            {"inside", star.inside},
            {"closed", star.closed}};
}

/// Grey levels of a spectrum, white at twice the power of random points and at frequency zero, which says nothing.
void drawSpectrum(Drawing& drawing, const Panel& panel, const std::string& name, const Spectrum& spectrum) {
    const auto side = static_cast<std::uint32_t>(spectrum.side());
    Image image(side, side, 3);
    for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
        const bool zero = i == spectrum.power.size() / 2;
        const double level = zero ? 1 : std::sqrt(std::clamp(spectrum.power[i] / 2, 0.0, 1.0));
        std::fill_n(image.pixels.data() + 3 * i, 3, static_cast<float>(level));
    }
    drawing.picture(panel.x, panel.y, panel.side, std::move(image));
    drawing.frame(panel.x, panel.y, panel.side, panel.side, 1, kGrey);
    drawing.text(panel.x, panel.y - 7, name, 12);
}

}  // namespace

Study studyDiscrepancy(const StudyRequest& request) {
    const std::size_t dims = request.dimensions.size();
    Study study{Json::array(), {}, {}};
    study.table =
        fmt::format("{:<16}{:>8}{:>12}{:>12}{:>12}{:>12}\n", "", "N", "star", "L2 star", "centred L2", "wrapped L2");
    const auto row = [&](const std::string& name, std::size_t n, double star, double l2, double centred,
                         double wrapped) {
        study.table += fmt::format("{:<16}{:>8}{:>12}{:>12.6f}{:>12.6f}{:>12.6f}\n", name, n,
                                   std::isnan(star) ? "-" : fmt::format("{:.6f}", star), l2, centred, wrapped);
    };
    std::map<std::size_t, double> starsOfRandom;
    const auto starOfRandom = [&](std::size_t n) {
        if (!starsOfRandom.contains(n)) starsOfRandom[n] = dims == 2 ? randomStar(n) : NAN;
        return starsOfRandom[n];
    };
    const auto expectation = [&](std::size_t n) {
        row("expect. random", n, starOfRandom(n), randomL2Star(n, dims), randomL2Centred(n, dims),
            randomL2Wrapped(n, dims));
    };
    PanelSheet sheet(dims == 2 ? request.samplers.size() : 0, 260, 4);
    std::size_t last = 0;
    for (std::size_t i = 0; i < request.samplers.size(); ++i) {
        const PointSet p = request.samplers[i].points(request.count, request.dimensions, request.seed);
        const StarDiscrepancy star = p.dims == 2 ? starDiscrepancy(p) : StarDiscrepancy{NAN};
        const double l2 = l2Star(p), centred = l2Centred(p), wrapped = l2Wrapped(p);
        const std::size_t n = p.size();
        if (last != 0 && n != last) expectation(last);
        last = n;
        row(request.samplers[i].name, n, star.value, l2, centred, wrapped);
        Json entry{{"sampler", request.samplers[i].name},
                   {"count", n},
                   {"dims", p.dims},
                   {"l2Star", l2},
                   {"l2Centred", centred},
                   {"l2Wrapped", wrapped}};
        if (p.dims == 2) entry["star"] = starJson(star);
        entry["random"] = {{"l2Star", randomL2Star(n, dims)},
                           {"l2Centred", randomL2Centred(n, dims)},
                           {"l2Wrapped", randomL2Wrapped(n, dims)}};
        if (p.dims == 2) entry["random"]["star"] = starOfRandom(n);
        study.json.push_back(std::move(entry));
        if (dims == 2) drawStarBox(sheet.drawing, sheet.panels[i], request.samplers[i].name, p, star);
    }
    expectation(last);
    study.drawing = std::move(sheet.drawing);
    return study;
}

Study studySpectrum(const StudyRequest& request) {
    Study study{Json::array(), {}, {}};
    const int extent = std::clamp(static_cast<int>(2.5 * std::sqrt(static_cast<double>(request.count))), 8, 100);
    PanelSheet sheet(request.samplers.size(), 220, 4);
    std::vector<Curve> curves;
    study.table = fmt::format("{:<16}{:>8}{:>26}{:>22}\n", "", "N", "power below root N / 4", "power near root N");
    for (std::size_t i = 0; i < request.samplers.size(); ++i) {
        std::vector<Spectrum> spectra;
        for (std::uint32_t s = 0; s < kSpectrumSeeds; ++s)
            spectra.push_back(
                pointSpectrum(request.samplers[i].points(request.count, {request.dimensions[0], request.dimensions[1]},
                                                         request.seed + s),
                              extent));
        const Spectrum mean = meanSpectrum(spectra);
        const std::vector<double> radial = mean.radialMean();
        const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(request.count)));
        double low = 0;
        const std::size_t rings = std::max<std::size_t>(root / 4, 1);
        for (std::size_t f = 0; f < rings; ++f) low += radial[f] / static_cast<double>(rings);
        study.table += fmt::format("{:<16}{:>8}{:>26.4f}{:>22.4f}\n", request.samplers[i].name,
                                   request.samplers[i].roundedCount(request.count), low,
                                   radial[std::min(root, radial.size()) - 1]);
        study.json.push_back({{"sampler", request.samplers[i].name},
                              {"count", request.samplers[i].roundedCount(request.count)},
                              {"seeds", kSpectrumSeeds},
                              {"radialMean", radial}});
        drawSpectrum(sheet.drawing, sheet.panels[i], request.samplers[i].name, mean);
        Curve curve{request.samplers[i].name, {}, false, false};
        for (std::size_t f = 0; f < radial.size(); ++f)
            curve.points.emplace_back(static_cast<double>(f + 1), radial[f]);
        curves.push_back(std::move(curve));
    }
    const double top = sheet.drawing.height + 30;
    sheet.drawing.width = std::max(sheet.drawing.width, 700.0);
    sheet.drawing.height = top + 300;
    drawChart(sheet.drawing, {60, top, 460, 240, false, "radial mean (random points: 1)", "frequency", "power"},
              curves);
    study.drawing = std::move(sheet.drawing);
    return study;
}

Study studyConvergence(const StudyRequest& request) {
    Study study{Json::array(), {}, {}};
    std::vector<std::uint32_t> counts;
    for (std::uint64_t n = 4; n <= request.count; n *= 2) counts.push_back(static_cast<std::uint32_t>(n));
    study.table = fmt::format("slope of log variance over log N, {} estimates each\n{:<16}", kConvergenceTrials, "");
    for (const Integrand& f : kIntegrands) study.table += fmt::format("{:>11}", f.name);
    study.table += '\n';
    std::vector<std::vector<Curve>> curves(kIntegrands.size());
    for (const StudiedSampler& sampler : request.samplers) {
        if (!sampler.choice) continue;  // the Poisson disk set has two dimensions and no exact number of points
        study.table += fmt::format("{:<16}", sampler.name);
        for (std::size_t k = 0; k < kIntegrands.size(); ++k) {
            const Convergence c =
                convergence(*sampler.choice, kIntegrands[k], counts, kConvergenceTrials, request.seed);
            Json list = Json::array();
            Curve curve{fmt::format("{} {:.2f}", sampler.name, c.slope), {}, true, false};
            for (const Estimates& e : c.estimates) {
                list.push_back({{"count", e.count},
                                {"variance", e.variance},
                                {"meanError", e.meanError},
                                {"standardError", e.standardError}});
                curve.points.emplace_back(e.count, e.variance);
            }
            curves[k].push_back(std::move(curve));
            study.table += fmt::format("{:>11.2f}", c.slope);
            study.json.push_back({{"sampler", sampler.name},
                                  {"integrand", kIntegrands[k].name},
                                  {"slope", c.slope},
                                  {"estimates", std::move(list)}});
        }
        study.table += '\n';
    }
    study.drawing = {3 * 440 + 20, 2 * 360 + 20, {}};
    for (std::size_t k = 0; k < kIntegrands.size(); ++k)
        drawChart(study.drawing,
                  {70 + static_cast<double>(k % 3) * 440, 40 + static_cast<double>(k / 3) * 360, 230, 270, true,
                   std::string(kIntegrands[k].name), "samples", "variance"},
                  curves[k]);
    return study;
}

}  // namespace vkpt
