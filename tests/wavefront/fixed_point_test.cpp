// The exact film's arithmetic against big integers on the host.
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>

#include "gpu/transfer.h"
#include "reference/accumulate.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using FixedPointProbe = GpuTest;
using boost::multiprecision::cpp_int;

struct In {
    glm::vec3 color{0};
    float alpha = 0;
    glm::uvec4 sums[3]{};
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

Result run(const std::vector<In>& inputs) {
    const std::vector<std::uint32_t> zero(4);
    const Buffer counters = makeStorage<std::uint32_t>(testDevice(), zero, "refused");
    ProbeOptions options;
    options.extraKinds = {BindingKind::StorageBuffer};
    options.extra = {counters};
    auto out = evaluate<Out>("fixed_point", inputs, options);
    return {std::move(out), readStorage<std::uint32_t>(testDevice(), counters, 0, 1)[0]};
}

/// floor(value x 2^48 + 1/2).
cpp_int exactFixedPoint(float value) {
    if (value == 0) return 0;
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);  // value = mantissa x 2^exponent, 24 bits
    const cpp_int whole = static_cast<std::int64_t>(mantissa * 0x1p24F);
    const int shift = exponent - 24 + 49;  // twice the value, so that the half is an integer
    const cpp_int twice = shift >= 0 ? cpp_int(whole << shift) : cpp_int(whole >> -shift);
    return (twice + 1) >> 1;
}

cpp_int wordsToInt(const glm::uvec3& words) {
    return cpp_int(words.x) | cpp_int(words.y) << 32 | cpp_int(words.z) << 64;
}

const cpp_int kModulus = cpp_int(1) << 96;

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

TEST_F(FixedPointProbe, RoundsEveryAcceptedValueExactly) {
    std::vector<In> inputs;
    const auto values = acceptedValues();
    for (std::size_t i = 0; i < values.size(); ++i)
        inputs.push_back(
            {.color = {values[i], values[(i * 7 + 3) % values.size()], 0.25F}, .alpha = i % 2 == 0 ? 1.0F : 0.0F});
    const auto [out, refused] = run(inputs);
    EXPECT_EQ(refused, 0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float value = inputs[i].color[c];
            const glm::uvec3 fixed(out[i].fixed[c]);
            ASSERT_EQ(wordsToInt(fixed), exactFixedPoint(value)) << value;
            const auto expected = reference::toFixedPoint(value);
            ASSERT_EQ(fixed, glm::uvec3(expected[0], expected[1], expected[2])) << value;
            ASSERT_EQ(glm::uvec3(out[i].sums[c]), fixed) << "added to zero";
        }
        ASSERT_EQ(out[i].sums[0].w, i % 2 == 0 ? 1 : 0) << "alpha counts the path";
        ASSERT_EQ(out[i].refused, 0);
    }
}

TEST_F(FixedPointProbe, SumsCarryThroughAllThreeWords) {
    std::vector<In> inputs;
    RandomInputs random(24);
    const auto word = [&] {
        const std::uint32_t kind = random.below(3);
        return kind == 0 ? 0xffffffffU : (kind == 1 ? 0U : random.bits());
    };
    for (int i = 0; i < 3000; ++i) {
        In in{.color = {random.between(0, 1e6F), 0x1p-48F, 0}, .alpha = 1};
        for (auto& sum : in.sums) sum = {word(), word(), word(), 0};
        in.sums[0].w = static_cast<std::uint32_t>(i);
        inputs.push_back(in);
    }
    const auto [out, refused] = run(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        ASSERT_EQ(wordsToInt(out[i].added), (wordsToInt(in.sums[0]) + wordsToInt(in.sums[1])) % kModulus);
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(wordsToInt(out[i].sums[c]), (wordsToInt(in.sums[c]) + exactFixedPoint(in.color[c])) % kModulus);
        ASSERT_EQ(out[i].sums[0].w, i + 1);
    }
}

TEST_F(FixedPointProbe, RefusesWholeContributionsOnce) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> bad = {nan,
                                    -nan,
                                    std::bit_cast<float>(0x7f800001U),
                                    std::bit_cast<float>(0xffffffffU),
                                    inf,
                                    -inf,
                                    -1,
                                    -0x1p-149F,
                                    -1e30F,
                                    0x1p40F,
                                    0x1p41F,
                                    std::numeric_limits<float>::max()};
    std::vector<In> inputs;
    for (const float value : bad)
        for (int channel = 0; channel < 4; ++channel) {
            In in{.color = {1, 2, 3}, .alpha = 1, .sums = {{1, 2, 3, 4}, {5, 6, 7, 0}, {8, 9, 10, 0}}};
            if (channel == 3) in.color = glm::vec3(value);
            if (channel < 3) in.color[channel] = value;
            inputs.push_back(in);
        }
    const auto [out, refused] = run(inputs);
    EXPECT_EQ(refused, inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        ASSERT_EQ(out[i].refused, 1) << i;
        for (int c = 0; c < 3; ++c) ASSERT_EQ(glm::uvec3(out[i].sums[c]), glm::uvec3(inputs[i].sums[c])) << i;
        ASSERT_EQ(out[i].sums[0].w, 5) << "the path still met something";
        FilmSums sums{};
        ASSERT_FALSE(reference::addContribution(sums, inputs[i].color)) << "the reference accepts it";
    }
}

TEST_F(FixedPointProbe, MinusZeroIsZero) {
    const auto [out, refused] = run({{.color = {-0.0F, 1, -0.0F}}});
    EXPECT_EQ(refused, 0);
    EXPECT_EQ(glm::uvec3(out[0].sums[0]), glm::uvec3(0));
    EXPECT_EQ(wordsToInt(out[0].sums[1]), exactFixedPoint(1));
    FilmSums sums{};
    EXPECT_TRUE(reference::addContribution(sums, {-0.0F, 1, -0.0F}));
}

}  // namespace
}  // namespace vkpt
