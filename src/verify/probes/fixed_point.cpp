// The exact film's arithmetic against 128-bit integers on the host.
#include <bit>
#include <cmath>
#include <limits>

#include "gpu/transfer.h"
#include "reference/accumulate.h"
#include "scene/pixel_filter.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

__extension__ using U128 = unsigned __int128;
constexpr U128 kModulus = U128{1} << 96U;

struct In {
    glm::vec3 color{0};
    float met = 0;  ///< kMet* of shaders/kernels/contribution.glsl
    glm::uvec4 sums[3]{};
    glm::vec4 second{0};  ///< the other contribution
};
struct Out {
    glm::uvec4 sums[3], fixed[3];
    glm::uvec3 added;
    std::uint32_t refused;
};
struct Result {
    std::vector<Out> out;
    std::uint32_t refused;
};

/// `filter`: the pixel filter, which may take light away.
Result run(Prober& prober, const std::vector<In>& inputs, std::uint32_t filter = kFilterBox) {
    const std::vector<std::uint32_t> zero(4);
    const Buffer counters = makeStorage<std::uint32_t>(prober.device(), zero, "refused");
    KernelOptions kernel;
    kernel.params.pixelFilter = filter;
    ProbeOptions options;
    options.specialization = specializationOf({}, {}, kernel);
    options.extraKinds = {BindingKind::StorageBuffer};
    options.extra = {counters};
    auto out = prober.evaluate<Out>("fixed_point", inputs, options);
    return {std::move(out), readStorage<std::uint32_t>(prober.device(), counters, 0, 1)[0]};
}

/// Names inputs by their colours.
auto colorsOf(Findings& findings, const std::vector<In>& inputs) {
    return findings.inputs([&](std::size_t i) { return "addContributions of " + show(inputs[i].color); });
}

/// floor(value x 2^48 + 1/2) of 0 <= value < 2^40.
U128 exactFixedPoint(float value) {
    if (value == 0) return 0;
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);  // value = mantissa x 2^exponent, 24 bits
    const U128 whole = static_cast<std::uint64_t>(mantissa * 0x1p24F);
    const int shift = exponent - 24 + 49;  // twice the value, so that the half is an integer
    const U128 twice = shift >= 0 ? whole << static_cast<unsigned>(shift)
                                  : (shift > -64 ? whole >> static_cast<unsigned>(-shift) : U128{0});
    return (twice + 1) >> 1U;
}

glm::uvec3 wordsOf(U128 value) {
    return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32U),
            static_cast<std::uint32_t>(value >> 64U)};
}
U128 wide(const glm::uvec3& words) { return U128{words.x} | U128{words.y} << 32U | U128{words.z} << 64U; }

/// Powers of two from 2^-60 to 2^39 with neighbours and random mantissas, ties of the rounding, the largest accepted.
std::vector<float> acceptedValues() {
    std::vector<float> values = {0,        0x1p-149F, 0x1p-126F,       0x1.fffffep39F,
                                 0x1p-49F, 0x3p-49F,  0x1.000002p-49F, 0x1.fffffep-50F};
    RandomInputs random(23);
    for (int e = -60; e < 40; ++e) {
        const float power = std::ldexp(1.0F, e);
        values.insert(values.end(), {power, std::nextafter(power, 0.0F), std::nextafter(power, 2 * power)});
        for (int i = 0; i < 20; ++i) values.push_back(power * random.between(1, 2));
    }
    return values;
}

void compareRounding(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    const auto values = acceptedValues();
    for (std::size_t i = 0; i < values.size(); ++i)
        inputs.push_back(
            {.color = {values[i], values[(i * 7 + 3) % values.size()], 0.25F}, .met = static_cast<float>(i % 3)});
    const auto [out, refused] = run(prober, inputs);
    const auto scope = colorsOf(findings, inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        for (int c = 0; c < 3; ++c) {
            const float value = inputs[i].color[c];
            const glm::uvec3 fixed(out[i].fixed[c]), exact = wordsOf(exactFixedPoint(value));
            const auto expected = reference::toFixedPoint(value);
            findings.equal("toFixedPoint", fixed, exact);
            findings.equal("the reference's", glm::uvec3(expected[0], expected[1], expected[2]), exact);
            findings.equal("sum with zero", glm::uvec3(out[i].sums[c]), fixed);
        }
        findings.equal("alpha", out[i].sums[0].w, i % 3 == 0 ? 0U : 1U);
        findings.equal("count of surfaces", out[i].sums[1].w, i % 3 == 2 ? 1U : 0U);
        findings.equal("isRefused", out[i].refused, 0U);
    }
    findings.equal("count of refusals", refused, 0U);
}

void compareCarries(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    RandomInputs random(24);
    const auto word = [&] {
        const std::uint32_t kind = random.below(3);
        return kind == 0 ? 0xffffffffU : (kind == 1 ? 0U : random.bits());
    };
    for (std::uint32_t i = 0; i < 3000; ++i) {
        In in{.color = {random.between(0, 1e6F), 0x1p-48F, 0}, .met = 1};
        for (auto& sum : in.sums) sum = {word(), word(), word(), 0};
        in.sums[0].w = i;
        inputs.push_back(in);
    }
    const auto [out, refused] = run(prober, inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("sums {}, {}, {}", show(inputs[i].sums[0]), show(inputs[i].sums[1]),
                           show(inputs[i].sums[2]));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const In& in = inputs[i];
        findings.equal("addFixed", out[i].added, wordsOf((wide(in.sums[0]) + wide(in.sums[1])) % kModulus));
        for (int c = 0; c < 3; ++c)
            findings.equal("sum", glm::uvec3(out[i].sums[c]),
                           wordsOf((wide(in.sums[c]) + exactFixedPoint(in.color[c])) % kModulus));
        findings.equal("alpha", out[i].sums[0].w, in.sums[0].w + 1);
    }
}

/// What filters take away: sums in two's complement, above and below 0.
void compareNegative(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    const auto values = acceptedValues();
    for (std::size_t i = 0; i < values.size(); ++i) {
        In in{.color = {-values[i], values[(i * 7 + 3) % values.size()], -values[(i * 11 + 5) % values.size()]}};
        if (i % 2 == 1) in.sums[0] = in.sums[1] = in.sums[2] = {7, 0, 0xffffffffU - static_cast<std::uint32_t>(i), 0};
        inputs.push_back(in);
    }
    const auto [out, refused] = run(prober, inputs, kFilterMitchell);
    const auto scope = colorsOf(findings, inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        for (int c = 0; c < 3; ++c) {
            const float value = inputs[i].color[c];
            const U128 exact = exactFixedPoint(std::abs(value));
            findings.equal("sum with what is below 0", glm::uvec3(out[i].sums[c]),
                           wordsOf((wide(inputs[i].sums[c]) + (value < 0 ? kModulus - exact : exact)) % kModulus));
        }
    }
    findings.equal("count of refusals", refused, 0U);
}

/// A contribution that is not finite or too large in any channel, or below 0 where the filter is not, changes nothing
/// and counts once.
void compareRefusals(Prober& prober, Findings& findings, std::uint32_t filter) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> bad = {nan,
                              -nan,
                              std::bit_cast<float>(0x7f800001U),
                              std::bit_cast<float>(0xffffffffU),
                              inf,
                              -inf,
                              -1e30F,
                              -0x1p40F,
                              0x1p40F,
                              0x1p41F,
                              std::numeric_limits<float>::max()};
    const bool mayTakeAway = hasNegativeLobes(filter);
    if (!mayTakeAway) bad.insert(bad.end(), {-1, -0x1p-149F, -0x1p-60F});
    std::vector<In> inputs;
    for (const float value : bad)
        for (int channel = 0; channel < 4; ++channel) {
            In in{.color = {1, 2, 3}, .met = 1, .sums = {{1, 2, 3, 4}, {5, 6, 7, 0}, {8, 9, 10, 0}}};
            if (channel == 3) in.color = glm::vec3(value);
            if (channel < 3) in.color[channel] = value;
            inputs.push_back(in);
        }
    const auto [out, refused] = run(prober, inputs, filter);
    const auto scope = colorsOf(findings, inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        findings.equal("isRefused", out[i].refused, 1U);
        for (int c = 0; c < 3; ++c)
            findings.equal("sum after a refusal", glm::uvec3(out[i].sums[c]), glm::uvec3(inputs[i].sums[c]));
        findings.equal("alpha", out[i].sums[0].w, 5U);  // the path still met something
        FilmSums sums{};
        findings.holds("the reference's refusal", !reference::addContribution(sums, inputs[i].color, mayTakeAway),
                       "it accepts");
    }
    findings.equal("count of refusals", refused, inputs.size());
}

/// Two contributions at once: what is refused of one does not touch the other.
void comparePairs(Prober& prober, Findings& findings) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    RandomInputs random(25);
    std::vector<In> inputs;
    std::uint32_t expectedRefusals = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
        In in{.color = random.inBox(glm::vec3(0), glm::vec3(1e6F)), .met = 1};
        in.second = glm::vec4(random.inBox(glm::vec3(0), glm::vec3(10)), 0);
        for (auto& sum : in.sums) sum = {random.bits(), 0xffffffffU, random.below(7), 0};
        if ((i & 1U) != 0) in.color[static_cast<int>(i % 3)] = nan;
        if ((i & 2U) != 0) in.second[static_cast<int>(i % 3)] = -1;
        expectedRefusals += (i & 1U) + (i >> 1U & 1U);
        inputs.push_back(in);
    }
    const auto [out, refused] = run(prober, inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("addContributions of {} and {}", show(inputs[i].color), show(glm::vec3(inputs[i].second)));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        for (int c = 0; c < 3; ++c) {
            U128 sum = wide(inputs[i].sums[c]);
            if ((i & 1U) == 0) sum += exactFixedPoint(inputs[i].color[c]);
            if ((i & 2U) == 0) sum += exactFixedPoint(inputs[i].second[c]);
            findings.equal("sum of two", glm::uvec3(out[i].sums[c]), wordsOf(sum % kModulus));
        }
    }
    findings.equal("count of refusals", refused, expectedRefusals);
}

void compareMinusZero(Prober& prober, Findings& findings) {
    const std::vector<In> inputs = {{.color = {-0.0F, 1, -0.0F}}};
    const auto [out, refused] = run(prober, inputs);
    const auto scope = findings.inputs([&](std::size_t) { return std::string("addContributions of (-0, 1, -0)"); });
    findings.at(0);
    findings.equal("count of refusals", refused, 0U);
    findings.equal("sum", glm::uvec3(out[0].sums[0]), glm::uvec3(0));
    findings.equal("sum", glm::uvec3(out[0].sums[1]), wordsOf(exactFixedPoint(1)));
    FilmSums sums{};
    findings.holds("the reference's refusal", reference::addContribution(sums, inputs[0].color, false), "it refuses");
}

}  // namespace

void checkFixedPoint(VerifyContext& context, Findings& findings) {
    compareRounding(context.prober(), findings);
    compareCarries(context.prober(), findings);
    compareNegative(context.prober(), findings);
    for (const std::uint32_t filter : {kFilterGaussian, kFilterMitchell})
        compareRefusals(context.prober(), findings, filter);
    comparePairs(context.prober(), findings);
    compareMinusZero(context.prober(), findings);
}

}  // namespace vkpt
