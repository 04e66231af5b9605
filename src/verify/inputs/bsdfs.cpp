#include "verify/inputs/bsdfs.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "scene/bsdf_spec.h"

namespace vkpt {
namespace {

std::uint32_t pack(glm::vec2 value) {
    const glm::vec2 v = glm::round(value * 65535.0F);
    return static_cast<std::uint32_t>(v.x) | static_cast<std::uint32_t>(v.y) << 16U;
}

constexpr glm::vec2 kAlphas[] = {{0, 0}, {1e-3F, 1e-3F}, {0.05F, 0.05F}, {0.3F, 0.3F}, {1, 1}, {0.1F, 0.4F}, {0.7F, 0}};

/// Which parts of a spec a model varies.
bool hasFacets(BsdfId m) {
    return m == BsdfId::Conductor || m == BsdfId::Dielectric || m == BsdfId::Plastic || m == BsdfId::TorranceSparrow ||
           m == BsdfId::CookTorrance;
}
bool hasGrooves(BsdfId m) { return m == BsdfId::TorranceSparrow || m == BsdfId::CookTorrance; }
bool hasExponents(BsdfId m) { return m == BsdfId::Phong || m == BsdfId::BlinnPhong || m == BsdfId::AshikhminShirley; }
bool hasSigma(BsdfId m) { return m == BsdfId::OrenNayar || m == BsdfId::Eon; }

class Maker {
public:
    explicit Maker(bool multiscatter) {
        out_.scene.features.multiscatter = multiscatter;
        out_.scene.features.bsdfModels = ~0U;
        for (std::uint32_t table = 0; table < 4; ++table) {
            const auto cells = makeSmoothTable(table);
            out_.scene.albedoTables.insert(out_.scene.albedoTables.end(), cells.begin(), cells.end());
        }
    }

    void addModel(BsdfId model) {
        BsdfSpec spec = defaultBsdf(model);
        spec.color = {0.9F, 0.6F, 0.3F};
        spec.diffuse = {0.2F, 0.5F, 0.7F};
        spec.weight = 0.7F;
        spec.specular = 0.6F;
        if (hasFacets(model)) return addFacets(spec);
        if (hasExponents(model)) return addExponents(spec);
        if (!hasSigma(model)) return add(spec, kNone, false);
        for (const float sigma : {0.0F, 0.1F, 0.5F, 1.0F}) {
            spec.sigma = sigma;
            add(spec, kNone, false);
        }
    }
    [[nodiscard]] BsdfCases take() { return std::move(out_); }

private:
    void addFacets(BsdfSpec spec) {
        for (const Distribution distribution : {Distribution::Ggx, Distribution::Beckmann, Distribution::Phong})
            for (const Masking masking : {Masking::Correlated, Masking::Separable, Masking::VGroove}) {
                spec.distribution = distribution;
                spec.masking = masking;
                if (hasGrooves(spec.model) != (masking == Masking::VGroove)) continue;
                for (const glm::vec2& alpha : kAlphas) addFresnel(spec, alpha);
            }
    }
    void addFresnel(BsdfSpec spec, const glm::vec2& alpha) {
        spec.alpha = alpha;
        const bool isDelta = std::max(alpha.x, alpha.y) < kDeltaAlpha && spec.model != BsdfId::CookTorrance;
        const bool tabled = !isDelta && !hasGrooves(spec.model);
        // Of a plastic the table is what it is made of: it has one whether interreflection counts or not.
        const std::uint32_t table =
            tabled ? kAlbedoTableWords * (1 + static_cast<std::uint32_t>(out_.cases.size() % 2)) : kNone;
        const bool azimuth = alpha.x != alpha.y && spec.model != BsdfId::Dielectric;
        spec.metal = spec.model == BsdfId::Conductor;
        spec.eta = spec.metal ? glm::vec3(0.2F, 0.9F, 1.4F) : glm::vec3(1.5F);
        spec.k = spec.metal ? glm::vec3(3.9F, 2.4F, 1.6F) : glm::vec3(0);
        add(spec, table, azimuth);
        if (spec.model == BsdfId::Plastic) return;
        spec.metal = hasGrooves(spec.model) || spec.model == BsdfId::Conductor;
        spec.eta = spec.metal ? glm::vec3(0.3F, 0.5F, 1.2F) : glm::vec3(spec.model == BsdfId::Dielectric ? 2.4F : 1.5F);
        add(spec, table, azimuth);
    }
    void addExponents(BsdfSpec spec) {
        constexpr glm::vec2 kExponents[] = {{0, 0}, {1, 1}, {10, 10}, {300, 300}, {1e4F, 1e4F}, {10, 1000}};
        for (const glm::vec2& exponents : kExponents)
            for (const bool conserving : {false, true}) {
                spec.exponent = exponents;
                spec.conserving = conserving;
                add(spec, kNone, false);
            }
    }
    void add(const BsdfSpec& spec, std::uint32_t table, bool azimuth) {
        BsdfRecord record = bsdfRecord(spec);
        record.average = {0.8F, 0.4F, 0.6F};  // as the tables: of no surface in particular
        record.table = table;
        if (azimuth && table != kNone) record.flags |= kBsdfAzimuthTable;
        out_.cases.push_back(
            {spec.model, static_cast<std::uint32_t>(out_.scene.bsdfs.size()),
             fmt::format("{} alpha {}/{} flags {:#x} eta {} exponents {}/{} sigma {}",
                         kBsdfModels[static_cast<std::size_t>(spec.model)].name, spec.alpha.x, spec.alpha.y,
                         record.flags, spec.eta.x, spec.exponent.x, spec.exponent.y, spec.sigma)});
        out_.scene.bsdfs.push_back(record);
    }

    BsdfCases out_;
};

}  // namespace

std::vector<AlbedoCell> makeSmoothTable(std::uint32_t seed) {
    constexpr std::uint32_t kCells = kAlbedoSide - 1;
    const auto value = [&](std::uint32_t i, std::uint32_t j) {
        const float x = static_cast<float>(i) / kCells, y = static_cast<float>(j) / kCells;
        const float s = 0.5F * static_cast<float>(seed);
        return glm::vec2(0.45F + 0.2F * std::sin(3 * x + y + s), 0.25F + 0.09F * std::cos(2 * y - 4 * x * y + s));
    };
    std::vector<AlbedoCell> cells;
    for (std::uint32_t j = 0; j < kCells; ++j)
        for (std::uint32_t i = 0; i < kCells; ++i)
            cells.push_back(
                {pack(value(i, j)), pack(value(i + 1, j)), pack(value(i, j + 1)), pack(value(i + 1, j + 1))});
    for (std::uint32_t j = 0; j < kCells; ++j) {
        const glm::vec2 a = value(9, j), b = value(9, j + 1);
        const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
        cells.push_back({bits(0.5F * a.y), bits(0.5F * b.y), bits(a.x), bits(b.x)});
    }
    for (std::uint32_t j = 0; j < kAlbedoSide; ++j) {
        // As a dielectric's row floats, as a conductor's pairs: the upper half of a float is about 0.25.
        const auto word = [&](glm::vec2 v) { return (std::bit_cast<std::uint32_t>(v.x) & ~0xffffU) | pack(v) >> 16U; };
        cells.push_back({word(value(5, j)), word(value(20, j)), std::bit_cast<std::uint32_t>(value(9, j).y), 0});
    }
    return cells;
}

BsdfCases makeBsdfCases(bool multiscatter) {
    Maker maker(multiscatter);
    for (const BsdfModelInfo& model : kBsdfModels)
        if (model.id != BsdfId::Gltf) maker.addModel(model.id);
    return maker.take();
}

}  // namespace vkpt
