// What the proofs of BSDFs loop over: every model of the registry, with parameters from smooth to rough.
#pragma once
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "analysis/bsdf_measures.h"
#include "reference/lone_bsdf.h"

namespace vkpt::test {

/// A spec and the isotropic roughnesses it is proven at; none: the spec's own. Tables are made once a spec.
struct BsdfCase {
    std::string spec;
    std::vector<double> alphas{};
};

inline const std::vector<BsdfCase>& quickCases() {
    static const std::vector<BsdfCase> kCases = {
        {"gltf:roughness=0.4"},
        {"gltf:roughness=0,color=0.8/0.5/0.1"},
        {"gltf:metallic=1,roughness=0.5,color=0.9/0.6/0.3"},
        {"lambert"},
        {"oren_nayar:sigma=0.7,color=1"},
        {"eon:roughness=0.8,color=1"},
        {"phong:diffuse=0.3"},
        {"blinn_phong:diffuse=0.3"},
        {"mirror:color=0.9"},
        {"conductor", {0, 0.05, 0.6}},
        {"conductor:alpha=0.1/0.5,distribution=beckmann"},
        {"dielectric:alpha=0.2", {0, 0.05, 0.5}},
        {"dielectric:alpha=0.2,distribution=beckmann", {0.3}},
        {"plastic", {0, 0.2}},
        {"torrance_sparrow", {0, 0.3}},
        {"cook_torrance"},
        {"cook_torrance:preset=copper_plastic"},
        {"ashikhmin_shirley"},
    };
    return kCases;
}

inline std::vector<BsdfCase> fullCases() {
    std::vector<BsdfCase> cases = quickCases();
    const std::vector<double> alphas{1e-3, 0.02, 0.1, 0.3, 1};
    for (const char* model : {"conductor", "dielectric", "plastic"})
        for (const char* distribution : {"ggx", "beckmann", "phong"})
            for (const char* masking : {"smith", "smith_separable"})
                cases.push_back(
                    {fmt::format("{}:alpha=0.2,distribution={},masking={}", model, distribution, masking), alphas});
    for (const char* distribution : {"ggx", "beckmann", "phong"}) {
        cases.push_back({fmt::format("torrance_sparrow:distribution={}", distribution), alphas});
        cases.push_back({fmt::format("dielectric:ior=1.1,alpha=0.2,distribution={}", distribution), {0.1, 0.6}});
        cases.push_back({fmt::format("dielectric:ior=diamond,alpha=0.4/0.1,distribution={}", distribution)});
        cases.push_back({fmt::format("plastic:alpha=0.1/0.4,distribution={}", distribution)});
    }
    for (const char* spec :
         {"gltf:roughness=1", "gltf:roughness=0.1", "gltf:metallic=0.5,roughness=0.7", "oren_nayar:sigma=0.1",
          "oren_nayar:sigma=1.5,color=1", "eon:roughness=0.1", "phong:exponent=0", "phong:exponent=3000",
          "blinn_phong:exponent=0", "blinn_phong:exponent=3000,diffuse=0.5", "blinn_phong:normalization=lecture",
          "conductor:metal=Au,alpha=0.02/0.3", "cook_torrance:alpha=0.5/0.05,weight=0.7,specular=0.5",
          "ashikhmin_shirley:exponent=0", "ashikhmin_shirley:exponent=2000/5,diffuse=1"})
        cases.push_back({spec});
    return cases;
}

inline glm::dvec3 directionAt(double cosine, double turns) {
    const double sine = std::sqrt(1 - cosine * cosine), phi = 2 * reference::kPiOf<double> * turns;
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// Made once a process: tables take a while.
inline const reference::LoneBsdf& loneBsdf(const std::string& spec, bool multiscatter) {
    static std::map<std::pair<std::string, bool>, std::unique_ptr<reference::LoneBsdf>> made;
    auto& lone = made[{spec, multiscatter}];
    if (!lone) lone = std::make_unique<reference::LoneBsdf>(parseBsdfSpec(spec), multiscatter);
    return *lone;
}

/// check(name, BSDF, BSDF seen from the other side): of every case, roughness and side.
template <class Check>
void forEachBsdf(const std::vector<BsdfCase>& cases, bool multiscatter, const Check& check) {
    for (const BsdfCase& c : cases) {
        const reference::LoneBsdf& lone = loneBsdf(c.spec, multiscatter);
        const std::size_t count = std::max<std::size_t>(1, c.alphas.size());
        for (std::size_t i = 0; i < count; ++i) {
            for (const bool front : {true, false}) {
                if (!front && !lone.transmits()) continue;
                BsdfDouble b = lone.seenFrom<double>(front), back = lone.seenFrom<double>(!front);
                std::string name = c.spec + (front ? "" : " from inside");
                if (!c.alphas.empty()) {
                    b.alphaX = b.alphaY = back.alphaX = back.alphaY = c.alphas[i];
                    name += fmt::format(" alpha {}", c.alphas[i]);
                }
                check(name, b, back);
            }
        }
    }
}

/// Evenly spread random numbers: errors of means fall faster than with random ones. [Roberts 18]
struct Spread {
    double uLobe;
    glm::dvec2 u;
};
inline Spread spread(std::uint32_t i) {
    const auto part = [i](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
    return {part(0.8191725133961645), {part(0.6710436067037893), part(0.5497004779019703)}};
}

/// Of `count` draws: mean flux, shares, and the largest weight.
struct SpreadDraws {
    glm::dvec3 mean{0};
    double invalid = 0, delta = 0, largest = 0;
    bool sound = true;  ///< all finite and none negative
};
inline SpreadDraws drawSpread(const BsdfDouble& b, const glm::dvec3& wo, std::uint32_t count) {
    SpreadDraws d;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Spread r = spread(i);
        const auto s = reference::sampleBsdf(b, wo, r.uLobe, r.u);
        if (s.pdf == 0) d.invalid += 1.0 / count;
        if (std::isinf(s.pdf)) d.delta += 1.0 / count;
        d.mean += s.weight * ((s.wi.z < 0 ? b.eta.x * b.eta.x : 1.0) / count);
        for (int c = 0; c < 3; ++c) {
            d.largest = std::max(d.largest, s.weight[c]);
            d.sound = d.sound && std::isfinite(s.weight[c]) && s.weight[c] >= 0;
        }
        d.sound = d.sound && s.pdf >= 0;
    }
    return d;
}

}  // namespace vkpt::test
