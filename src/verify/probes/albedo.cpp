// Lookups of albedo tables, and the lobe of interreflection, against the reference in double.
#include <cmath>

#include "reference/bsdf/compensation.h"
#include "verify/context.h"
#include "verify/inputs/bsdfs.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 w;
    std::uint32_t table;
    glm::vec2 alpha;
    float c;                ///< of the lobe of interreflection
    std::uint32_t azimuth;  ///< rows are azimuths
    glm::vec2 u, unused{0};
};
struct Out {
    glm::vec4 albedo, mean;
    glm::vec3 direction;
    float pdf;
    glm::vec4 metal;
    float metalPlace;
    glm::vec3 glass;
};

/// Every cell's neighbourhood, the corners of the table, both sides of the surface.
std::vector<In> grid() {
    std::vector<In> inputs;
    RandomInputs random(85);
    for (const float cosine : {1.0F, -1.0F, 0.0F, 1e-4F, 0.5F})
        for (const float alpha : {1e-4F, 1.0F})
            for (const float turns : {0.0F, 0.25F, 0.5F, 0.75F})
                for (const std::uint32_t azimuth : {0U, 1U})
                    inputs.push_back({atCosine(cosine, turns), kAlbedoTableWords, glm::vec2(alpha), alpha * alpha,
                                      azimuth, glm::vec2(turns, 0)});
    for (int i = 0; i < 4000; ++i) {
        const float side = i % 5 == 0 ? -1.0F : 1.0F;
        const auto alpha = [&] { return std::exp(random.between(std::log(kDeltaAlpha), 0)); };
        const glm::vec2 both(alpha(), alpha());
        inputs.push_back({atCosine(side * random.unit(), random.unit()), kAlbedoTableWords * random.below(3), both,
                          both.x * both.y, random.below(2), random.square()});
    }
    return inputs;
}

reference::Bsdf<double> bsdfOf(const In& in) {
    reference::Bsdf<double> b;
    b.alphaX = in.alpha.x;
    b.alphaY = in.alpha.y;
    b.flags = in.azimuth != 0 ? kBsdfAzimuthTable : 0;
    return b;
}

glm::dvec3 whole(const reference::Albedo<double>& a) { return {a.first(), a.second, a.lost}; }

void compare(const SceneArrays& arrays, const In& in, const Out& out, Findings& findings) {
    const reference::AlbedoTable table{&arrays.albedoTables[in.table]};
    const auto b = bsdfOf(in);
    findings.near("albedo", glm::vec3(out.albedo), whole(table.albedo(reference::albedoPlace(b, glm::dvec3(in.w)))),
                  1e-5);
    findings.near("mean albedo", glm::vec3(out.mean), whole(reference::albedoMean(b, table)), 1e-5);
    const double row = reference::albedoRow(reference::meanAlpha(b));
    const auto metal = table.metalWalk(row);
    findings.near("walk on metal", out.metal, glm::dvec4(metal.cosine, metal.escape), 1e-5);
    findings.near("its place", out.metalPlace, metal.place, 1e-5);
    const auto glass = table.glassWalk(row);
    findings.near("walk on glass", out.glass, glm::dvec3(glass.share, glass.slope, glass.place), 1e-5);
    const glm::dvec3 wi = reference::sampleLostEnergyLobe(b, glm::dvec2(in.u));
    findings.near("direction of interreflection", out.direction, wi, 4e-6);
    // The density belongs to the direction that the shader drew.
    findings.near("its pdf", out.pdf, reference::lostEnergyLobePdf(b, glm::dvec3(out.direction)), 1e-9, 2e-5);
}

}  // namespace

void checkAlbedo(VerifyContext& context, Findings& findings) {
    SceneArrays arrays;
    for (std::uint32_t table = 0; table < 3; ++table) {
        const auto cells = makeSmoothTable(7 + table);
        arrays.albedoTables.insert(arrays.albedoTables.end(), cells.begin(), cells.end());
    }
    const auto inputs = grid();
    const auto out = ProbeScene(context.prober(), arrays).evaluate<Out>(findings, "albedo", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("table {}, w {}, alpha {}, {}, u {}", in.table, show(in.w), show(in.alpha),
                           in.azimuth != 0 ? "azimuths" : "roughnesses", show(in.u));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compare(arrays, inputs[i], out[i], findings);
    }
}

}  // namespace vkpt
