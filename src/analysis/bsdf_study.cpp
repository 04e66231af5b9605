#include "analysis/bsdf_study.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "analysis/bsdf_measures.h"
#include "analysis/bsdf_pictures.h"
#include "analysis/facet_study.h"
#include "reference/lone_bsdf.h"

namespace vkpt {
namespace {

using reference::LoneBsdf;

constexpr double kCosines[] = {1, 0.9, 0.7, 0.5, 0.3, 0.1, 0.03};
constexpr double kTurns = 0.1;  ///< azimuth of all directions: off the axes of anisotropy
constexpr std::uint32_t kPairs = 4000;

/// What is measured for one direction.
struct Row {
    double cosine = 0;
    BsdfIntegrals on;
    double energyOff = 0;  ///< luminance of the albedo without compensation of interreflection
    BsdfDraws draws;
    TestResult chiSquare;
};

/// One side of a BSDF.
struct Side {
    std::string name;
    std::vector<Row> rows;
    double reciprocity = 0;
};

glm::dvec3 directionAt(double cosine) {
    const double sine = std::sqrt(1 - cosine * cosine), phi = 2 * std::numbers::pi * kTurns;
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

double energy(const glm::dvec3& albedo) { return reference::luminance(albedo); }

Side measureSide(const LoneBsdf& on, const LoneBsdf& off, bool front, const BsdfStudyRequest& request) {
    const BsdfDouble b = on.seenFrom<double>(front), back = on.seenFrom<double>(!front);
    const BsdfDouble bare = off.seenFrom<double>(front);
    Side side;
    side.name = front ? "outside" : "inside";
    side.reciprocity = reciprocityError(b, back, kPairs, request.seed);
    for (const double cosine : kCosines) {
        const glm::dvec3 wo = directionAt(cosine);
        Row row;
        row.cosine = cosine;
        row.on = integrateBsdf(b, wo);
        row.energyOff = energy(integrateBsdf(bare, wo).albedo());
        row.draws = drawBsdf(b, wo, request.draws, request.seed);
        row.chiSquare = testBsdfDraws(b, wo, request.draws, request.seed + 1);
        side.rows.push_back(row);
    }
    return side;
}

std::vector<Side> measure(const BsdfSpec& spec, const BsdfStudyRequest& request) {
    const LoneBsdf on(spec, true), off(spec, false);
    std::vector<Side> sides{measureSide(on, off, true, request)};
    if (on.transmits()) sides.push_back(measureSide(on, off, false, request));
    return sides;
}

Json colorJson(const glm::dvec3& c) { return Json::array({c.x, c.y, c.z}); }

Json rowJson(const Row& row) {
    return {{"cosine", row.cosine},
            {"reflected", colorJson(row.on.reflected)},
            {"transmitted", colorJson(row.on.transmitted)},
            {"energy", energy(row.on.albedo())},
            {"energyWithoutMultiscatter", row.energyOff},
            {"pdfIntegral", row.on.pdf},
            {"deltaShare", row.draws.delta},
            {"absorbedShare", row.draws.invalid},
            {"chiSquareP", row.chiSquare.p},
            {"weightVariance", row.draws.relativeVariance},
            {"largestWeight", row.draws.largest}};
}

Json sidesJson(const std::string& name, const BsdfSpec& spec, const std::vector<Side>& sides) {
    Json list = Json::array();
    for (const Side& side : sides) {
        Json rows = Json::array();
        for (const Row& row : side.rows) rows.push_back(rowJson(row));
        list.push_back({{"side", side.name}, {"reciprocityError", side.reciprocity}, {"angles", std::move(rows)}});
    }
    return {{"spec", name}, {"bsdf", bsdfToJson(spec)}, {"sides", std::move(list)}};
}

std::string sidesTable(const std::string& name, const std::vector<Side>& sides) {
    std::string table = name + "\n";
    for (const Side& side : sides) {
        table += fmt::format("seen from {}; worst reciprocity error {:.1e}\n", side.name, side.reciprocity);
        table +=
            "    cos  reflected R      G      B  transmitted  energy  single   pdf    delta  absorbed  chi2 p  "
            "variance  largest\n";
        for (const Row& r : side.rows) {
            const glm::dvec3& a = r.on.reflected;
            table += fmt::format(
                "  {:5.2f}       {:.4f} {:.4f} {:.4f}       {:.4f}  {:.4f}  {:.4f}  {:.4f}  {:.4f}    {:.4f}  {:6.3f}"
                "  {:8.4f}  {:7.3f}\n",
                r.cosine, a.x, a.y, a.z, energy(r.on.transmitted), energy(r.on.albedo()), r.energyOff, r.on.pdf,
                r.draws.delta, r.draws.invalid, r.chiSquare.p, r.draws.relativeVariance, r.draws.largest);
        }
    }
    return table;
}

/// How far the first is from the second at each angle, and over all directions of arrival.
void compare(const std::vector<Side>& a, const std::vector<Side>& b, Study& study) {
    Json list = Json::array();
    study.table += "difference of energy, first less second\n    cos  difference\n";
    for (std::size_t i = 0; i < a[0].rows.size(); ++i) {
        const double d = energy(a[0].rows[i].on.albedo()) - energy(b[0].rows[i].on.albedo());
        study.table += fmt::format("  {:5.2f}   {:+.4f}\n", a[0].rows[i].cosine, d);
        list.push_back({{"cosine", a[0].rows[i].cosine}, {"energyDifference", d}});
    }
    study.json = {{"bsdfs", std::move(study.json)}, {"comparison", std::move(list)}};
}

}  // namespace

Study studyBsdf(const BsdfStudyRequest& request) {
    Study study{Json::array(), {}, {}};
    std::vector<std::vector<Side>> all;
    for (std::size_t i = 0; i < request.specs.size(); ++i) {
        all.push_back(measure(request.specs[i], request));
        study.json.push_back(sidesJson(request.names[i], request.specs[i], all.back()));
        if (request.facets) study.json.back()["facets"] = facetsJson(LoneBsdf(request.specs[i], false));
        study.table += sidesTable(request.names[i], all.back());
    }
    if (all.size() == 2)
        compare(all[0], all[1], study);
    else
        study.json = Json(study.json[0]);
    if (request.picture) {
        std::vector<LoneBsdf> bsdfs;
        for (const BsdfSpec& spec : request.specs) bsdfs.emplace_back(spec, request.multiscatter);
        std::vector<PicturedBsdf> pictured;
        for (std::size_t i = 0; i < bsdfs.size(); ++i)
            pictured.push_back({request.names[i], &bsdfs[i], request.multiscatter});
        study.drawing = drawBsdfs(pictured);
    }
    return study;
}

}  // namespace vkpt
