// The arithmetic of the film's layers against 128-bit integers on the host.
#include <bit>
#include <cmath>
#include <limits>

#include "reference/accumulate.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

__extension__ using U128 = unsigned __int128;
constexpr U128 kMask96 = (U128{1} << 96U) - 1;

struct In {
    glm::vec4 value{0};
    glm::uvec4 path[3]{}, sums[2]{};
};
struct Out {
    glm::uvec4 fixed[3];  ///< w: refused
    glm::uvec2 luminance;
    std::uint32_t tooBright, unused;
    glm::uvec4 square, sum;
};

glm::uvec4 wordsOf(U128 value) {
    return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32U),
            static_cast<std::uint32_t>(value >> 64U), static_cast<std::uint32_t>(value >> 96U)};
}
U128 wide(const glm::uvec4& w) { return U128{w.x} | U128{w.y} << 32U | U128{w.z} << 64U | U128{w.w} << 96U; }

/// sign(v) floor(|v| x 2^48 + 1/2) modulo 2^96, from the bits of the float. Requires |v| < 2^40.
U128 exactSigned(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t exponent = bits >> 23U & 0xffU;
    if (exponent == 0) return 0;
    const U128 mantissa = (bits & 0x7fffffU) | 0x800000U;
    const int shift = static_cast<int>(exponent) - 150 + 49;  // twice the value, so that the half is an integer
    const U128 twice = shift >= 0 ? mantissa << static_cast<unsigned>(shift)
                                  : (shift > -64 ? mantissa >> static_cast<unsigned>(-shift) : U128{0});
    const U128 magnitude = (twice + 1) >> 1U;
    return (bits >> 31U != 0 ? -magnitude : magnitude) & kMask96;
}

bool isInRange(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) &&
           std::fmax(std::fmax(std::abs(v.x), std::abs(v.y)), std::abs(v.z)) < 0x1p31F;
}

/// Magnitudes from 2^-60 to 2^31 with neighbours, of either sign; what is no number; the edges of the range.
std::vector<float> values() {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> list = {0,         -0.0F,      nan,      -nan,           inf,
                               -inf,      0x1p31F,    -0x1p31F, 0x1.fffffep30F, -0x1.fffffep30F,
                               0x1p-149F, -0x1p-126F, 0x1p-49F, -0x1p-49F,      std::numeric_limits<float>::max()};
    RandomInputs random(61);
    for (int e = -60; e < 31; ++e)
        for (const float sign : {1.0F, -1.0F}) {
            const float power = sign * std::ldexp(1.0F, e);
            list.insert(list.end(), {power, std::nextafter(power, 0.0F), power * random.between(1, 2)});
        }
    return list;
}

/// A path's channel: often small, sometimes at the limit of the luminance or beyond.
glm::uvec4 randomChannel(RandomInputs& random) {
    const std::uint32_t kind = random.below(8), high = random.bits();
    const std::uint32_t z = kind == 0   ? 0xffffU
                            : kind == 1 ? 0x10000U
                            : kind == 2 ? high
                            : kind < 5  ? high & 0xffffU
                                        : 0;
    return {kind == 3 ? 0xffffffffU : random.bits(), kind == 4 ? 0xffffffffU : random.bits(), z, 0};
}

std::vector<In> makeInputs() {
    const std::vector<float> list = values();
    std::vector<In> inputs;
    RandomInputs random(62);
    const auto word = [&] {
        const std::uint32_t kind = random.below(3);
        return kind == 0 ? 0xffffffffU : kind == 1 ? 0U : random.bits();
    };
    for (std::size_t i = 0; i < 4 * list.size(); ++i) {
        In in;
        in.value = {list[i % list.size()], list[(i * 7 + 3) % list.size()], 0.25F, 0};
        for (auto& channel : in.path) channel = randomChannel(random);
        for (auto& sum : in.sums) sum = {word(), word(), word(), word()};
        inputs.push_back(in);
    }
    return inputs;
}

void compareLuminance(const In& in, const Out& out, Findings& findings) {
    const bool dim = in.path[0].z < 0x10000U && in.path[1].z < 0x10000U && in.path[2].z < 0x10000U;
    findings.equal("isTooBright", out.tooBright, dim ? 0U : 1U);
    const auto reference = reference::pathLuminance({in.path[0], in.path[1], in.path[2]});
    findings.equal("the reference's range", reference.has_value(), dim);
    if (!dim) return;
    const auto cut = [](const glm::uvec4& sum) { return wide(sum) >> 24U; };
    const U128 weighted = cut(in.path[0]) * 13933 + cut(in.path[1]) * 46871 + cut(in.path[2]) * 4732;
    const auto luminance = static_cast<std::uint64_t>((weighted + 32768) >> 16U);
    findings.equal("path luminance", out.luminance,
                   glm::uvec2(static_cast<std::uint32_t>(luminance), static_cast<std::uint32_t>(luminance >> 32U)));
    findings.equal("the reference's luminance", *reference, luminance);
    findings.equal("its square", out.square, wordsOf(U128{luminance} * luminance));
    uvec4 sum = in.sums[0];
    reference::addSquare(sum, luminance);
    findings.equal("the reference's square", sum, wordsOf(wide(in.sums[0]) + U128{luminance} * luminance));
}

}  // namespace

void checkFilmLayers(VerifyContext& context, Findings& findings) {
    const std::vector<In> inputs = makeInputs();
    const auto out = context.prober().evaluate<Out>("film_layers", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("value {}, path {}, {}, {}", show(inputs[i].value), show(inputs[i].path[0]),
                           show(inputs[i].path[1]), show(inputs[i].path[2]));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const bool inRange = isInRange(glm::vec3(inputs[i].value));
        findings.equal("refusal", out[i].fixed[0].w, inRange ? 0U : 1U);
        for (int c = 0; c < 3 && inRange; ++c) {
            const glm::uvec3 exact(wordsOf(exactSigned(inputs[i].value[c])));
            const auto reference = reference::toSignedFixedPoint(inputs[i].value[c]);
            findings.equal("toSignedFixedPoint", glm::uvec3(out[i].fixed[c]), exact);
            findings.equal("the reference's", glm::uvec3(reference[0], reference[1], reference[2]), exact);
        }
        compareLuminance(inputs[i], out[i], findings);
        findings.equal("sum of 128 bits", out[i].sum, wordsOf(wide(inputs[i].sums[0]) + wide(inputs[i].sums[1])));
    }
}

}  // namespace vkpt
