// The glTF BSDF against textbook forms written anew here, and against what every BSDF owes.
#include "reference/bsdf.h"

#include <gtest/gtest.h>

#include "bsdf_oracle.h"
#include "reference/hash.h"
#include "statistics.h"

namespace vkpt::reference {
namespace {

using D3 = Vec3<double>;

struct Case {
    D3 base;
    double metallic, roughness;
};
const Case kCases[] = {{{0.8, 0.5, 0.2}, 0, 1}, {{0.8, 0.5, 0.2}, 0, 0.3},   {{0.9, 0.6, 0.3}, 1, 0.5},
                       {{1, 1, 1}, 1, 0.2},     {{0.5, 0.5, 0.5}, 0.4, 0.7}, {{0, 0, 0}, 0, 0.4}};
const double kCosines[] = {0.05, 0.3, 0.7, 0.999};

D3 directionAt(double cosine, double turns) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(2 * kPiOf<double> * turns), sine * std::sin(2 * kPiOf<double> * turns), cosine};
}

template <class Real>
Bsdf<Real> bsdfOf(const Case& c) {
    const Real roughness(c.roughness);
    return makeGltfBsdf<Real>(Vec3<Real>(c.base), Real(c.metallic), roughness * roughness);
}

template <class Check>
void forAllPairs(Check check) {
    for (const Case& c : kCases) {
        for (const double cosO : kCosines) {
            for (const double cosI : kCosines) {
                for (const double turns : {0.0, 0.13, 0.5}) check(c, directionAt(cosO, 0), directionAt(cosI, turns));
            }
        }
    }
}

TEST(Schlick, EqualsThePower) {
    for (const double c : {0.0, 0.2, 0.5, 1.0}) EXPECT_NEAR(schlickWeight(c), std::pow(1 - c, 5), 1e-15);
    EXPECT_EQ(schlickWeight(1.0F), 0.0F);
}

TEST(GltfBsdf, EvalEqualsTheTextbook) {
    forAllPairs([](const Case& c, const D3& wo, const D3& wi) {
        const D3 expected = test::gltfOracle(c.base, c.metallic, c.roughness, wo, wi);
        const D3 f = evalBsdf(bsdfOf<double>(c), wo, wi);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(f[i], expected[i], 1e-8 * (1 + expected[i]));  // 0.04 is a float constant
    });
}

TEST(GltfBsdf, FloatFollowsDouble) {
    forAllPairs([](const Case& c, const D3& wo, const D3& wi) {
        const Vec3<float> wof(wo), wif(wi);
        const D3 truth = evalBsdf(bsdfOf<double>(c), wo, wi);
        const D3 f(evalBsdf(bsdfOf<float>(c), wof, wif));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(f[i], truth[i], 2e-5 * (1 + truth[i]));
        const double pdf = pdfBsdf(bsdfOf<double>(c), wo, wi);
        EXPECT_NEAR(pdfBsdf(bsdfOf<float>(c), wof, wif), pdf, 2e-5 * (1 + pdf));
    });
}

TEST(GltfBsdf, IsReciprocal) {
    forAllPairs([](const Case& c, const D3& wo, const D3& wi) {
        const D3 there = evalBsdf(bsdfOf<double>(c), wo, wi), back = evalBsdf(bsdfOf<double>(c), wi, wo);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(there[i], back[i], 1e-12 * (1 + there[i]));
    });
}

TEST(GltfBsdf, IsZeroBelowTheHorizon) {
    const Bsdf<double> b = bsdfOf<double>(kCases[0]);
    const D3 up = directionAt(0.5, 0), down(up.x, up.y, -up.z);
    EXPECT_TRUE(isBlack(evalBsdf(b, up, down)));
    EXPECT_TRUE(isBlack(evalBsdf(b, down, up)));
    EXPECT_EQ(pdfBsdf(b, up, down), 0);
    EXPECT_EQ(pdfBsdf(b, down, up), 0);
    EXPECT_TRUE(isBlack(sampleBsdf(b, down, 0.1, {0.2, 0.3}).weight));
}

/// Integral over the upper hemisphere by the midpoint rule on (cos^2, phi).
template <class F>
D3 integrate(F f, int steps = 600) {
    D3 sum(0);
    for (int i = 0; i < steps; ++i) {
        const double cosine = std::sqrt((i + 0.5) / steps);  // d cos^2 = 2 cos d cos
        for (int j = 0; j < steps; ++j) sum += f(directionAt(cosine, (j + 0.5) / steps)) / (2 * cosine);
    }
    return sum * (2 * kPiOf<double> / steps / steps);
}

// What the density lacks to 1 is the share of sampled directions that fall below the horizon.
TEST(GltfBsdf, DensityIntegratesToOneButForTheSubHorizonShare) {
    for (const Case& c : kCases) {
        for (const double cosO : {0.3, 0.9}) {
            const D3 wo = directionAt(cosO, 0);
            const Bsdf<double> b = bsdfOf<double>(c);
            const double integral = integrate([&](const D3& wi) { return D3(pdfBsdf(b, wo, wi)); }).x;
            int below = 0;
            constexpr int kDraws = 40000;
            for (std::uint32_t i = 0; i < kDraws; ++i) {
                const glm::uvec4 h = hash({i, 1, 1, 1});
                if (sampleBsdf(b, wo, double{toUnit(h.x)}, {toUnit(h.y), toUnit(h.z)}).wi.z <= 0) ++below;
            }
            EXPECT_NEAR(integral + static_cast<double>(below) / kDraws, 1, 0.008) << c.roughness << " " << cosO;
        }
    }
}

TEST(GltfBsdf, WhiteMetalReflectsAtMostWhatArrives) {
    for (const double roughness : {0.2, 0.5, 1.0}) {
        for (const double cosO : {0.1, 0.5, 0.95}) {
            const D3 wo = directionAt(cosO, 0);
            const Bsdf<double> b = bsdfOf<double>({D3(1), 1, roughness});
            const double albedo = integrate([&](const D3& wi) { return evalBsdf(b, wo, wi) * wi.z; }).x;
            EXPECT_LE(albedo, 1.0005) << roughness << " " << cosO;
            EXPECT_GT(albedo, 0.3);
        }
    }
}

// The specification's Fresnel mix is reciprocal but gains energy at grazing angles (1.28 at roughness 0.3, cosine
// 0.1): the half vector's Fresnel does not know how much the layer reflects as a whole. Over all directions of
// arrival together the gain of a white surface stays below 3 %, which bounds what a closed white room can gain.
TEST(GltfBsdf, WhiteDielectricGainsAtMostThreePercentOverAllDirections) {
    for (const double roughness : {0.2, 0.3, 0.5, 1.0}) {
        double total = 0;
        constexpr int kSteps = 24;
        for (int i = 0; i < kSteps; ++i) {
            const double cosO = std::sqrt((i + 0.5) / kSteps);
            const D3 wo = directionAt(cosO, 0);
            const Bsdf<double> b = bsdfOf<double>({D3(1), 0, roughness});
            total += integrate([&](const D3& wi) { return evalBsdf(b, wo, wi) * wi.z; }, 200).x / kSteps;
        }
        EXPECT_LE(total, 1.03) << roughness;
        EXPECT_GT(total, 0.9) << roughness;
    }
}

TEST(GltfBsdf, WeightIsFCosineOverPdf) {
    for (const Case& c : kCases) {
        const D3 wo = directionAt(0.6, 0.2);
        const Bsdf<double> b = bsdfOf<double>(c);
        for (std::uint32_t i = 0; i < 200; ++i) {
            const glm::uvec4 h = hash({i, 2, 2, 2});
            const auto s = sampleBsdf(b, wo, double{toUnit(h.x)}, {toUnit(h.y), toUnit(h.z)});
            if (s.wi.z <= 0) {
                EXPECT_TRUE(isBlack(s.weight));
                continue;
            }
            EXPECT_NEAR(glm::length(s.wi), 1, 1e-12);
            EXPECT_NEAR(s.pdf, pdfBsdf(b, wo, s.wi), 1e-12 * s.pdf);
            const D3 expected = evalBsdf(b, wo, s.wi) * (s.wi.z / s.pdf);
            EXPECT_NEAR(glm::distance(s.weight, expected), 0, 1e-12);
        }
    }
}

// Directions fall where the density says, lobes mixed. Cells in (cos^2, phi); a column for those below the horizon.
TEST(GltfBsdf, SamplesFollowTheDensity) {
    constexpr std::size_t kRows = 24, kColumns = 24;
    constexpr int kDraws = 100000, kSub = 24;
    for (const Case& c : kCases) {
        for (const double cosO : {0.25, 0.8}) {
            const D3 wo = directionAt(cosO, 0.1);
            const Bsdf<double> b = bsdfOf<double>(c);
            const Bsdf<float> bf = bsdfOf<float>(c);
            std::vector<double> counts(kRows * kColumns), expected(kRows * kColumns);
            for (std::uint32_t i = 0; i < kDraws; ++i) {
                const glm::uvec4 h = hash({i, 3, 3, 3});
                const D3 wi = sampleBsdf(bf, Vec3<float>(wo), toUnit(h.x), {toUnit(h.y), toUnit(h.z)}).wi;
                if (wi.z <= 0) continue;
                const double turns = std::atan2(wi.y, wi.x) / (2 * kPiOf<double>);
                const auto row = std::min(kRows - 1, static_cast<std::size_t>(wi.z * wi.z * kRows));
                const auto column = static_cast<std::size_t>((turns < 0 ? turns + 1 : turns) * kColumns) % kColumns;
                counts[row * kColumns + column] += 1;
            }
            for (std::size_t cell = 0; cell < expected.size(); ++cell) {
                for (int i = 0; i < kSub * kSub; ++i) {
                    const double cos2 = (static_cast<double>(cell / kColumns) + (i / kSub + 0.5) / kSub) / kRows;
                    const double turns = (static_cast<double>(cell % kColumns) + (i % kSub + 0.5) / kSub) / kColumns;
                    const double density = pdfBsdf(b, wo, directionAt(std::sqrt(cos2), turns)) / std::sqrt(cos2);
                    expected[cell] += kDraws * density * kPiOf<double> / (kRows * kColumns * kSub * kSub);
                }
            }
            EXPECT_LT(test::chiSquareDeviate(counts, expected), 4.5) << c.metallic << " " << c.roughness << " " << cosO;
        }
    }
}

TEST(GltfBsdf, MirrorIsADeltaLobe) {
    const D3 wo = directionAt(0.6, 0.3);
    const Bsdf<double> metal = makeGltfBsdf(D3(0.9, 0.5, 0.1), 1.0, 0.0);
    EXPECT_TRUE(metal.isDelta());
    EXPECT_FALSE(hasDensity(metal, wo));
    const auto s = sampleBsdf(metal, wo, 0.99, {0.4, 0.6});
    EXPECT_EQ(s.wi, D3(-wo.x, -wo.y, wo.z));
    EXPECT_TRUE(std::isinf(s.pdf));
    EXPECT_NEAR(s.weight.y, 0.5 + 0.5 * std::pow(0.4, 5), 1e-12);

    const Bsdf<double> plastic = makeGltfBsdf(D3(0.9, 0.5, 0.1), 0.0, 0.0);
    EXPECT_TRUE(plastic.isDelta() && hasDensity(plastic, wo));
    EXPECT_NEAR(sampleBsdf(plastic, wo, 0.0, {0.4, 0.6}).weight.x,
                (0.04 + 0.96 * std::pow(0.4, 5)) / gltfShares(plastic, wo).specular, 1e-7);
}

// The limit is continuous: a lobe just above the threshold sends as much light into the mirror's cone.
TEST(GltfBsdf, NarrowLobeTendsToTheMirror) {
    const D3 wo = directionAt(0.6, 0.3);
    const Bsdf<double> narrow = makeGltfBsdf(D3(0.9, 0.5, 0.1), 1.0, 0.0102 * 0.0102);
    ASSERT_FALSE(narrow.isDelta());
    D3 mean(0);
    constexpr std::uint32_t kDraws = 2000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const glm::uvec4 h = hash({i, 4, 4, 4});
        const auto s = sampleBsdf(narrow, wo, 0.5, {toUnit(h.y), toUnit(h.z)});
        mean += s.weight / double{kDraws};
        EXPECT_GT(glm::dot(s.wi, D3(-wo.x, -wo.y, wo.z)), 0.98);
    }
    EXPECT_NEAR(mean.y, 0.5 + 0.5 * std::pow(0.4, 5), 1e-3);
}

TEST(GltfBsdf, BlackMetalIsAllSpecular) {
    EXPECT_EQ(gltfShares(makeGltfBsdf(D3(0), 1.0, 0.25), directionAt(0.7, 0)).specular, 1);
    EXPECT_EQ(gltfShares(makeGltfBsdf(D3(0), 1.0, 0.25), directionAt(1, 0)).specular, 1);  // not even Fresnel: no 0/0
}

}  // namespace
}  // namespace vkpt::reference
