// Functions of shaders/math/exponential.glsl and erf.glsl against the C++ library in double.
#include <algorithm>
#include <cmath>

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    float x, q, t, y;     ///< of erf, its inverse, ln(1 + t), 1 - exp(y)
    float tan2, e, u, n;  ///< cosine power; the angle whose cos^n is 1 - u
};
struct Out {
    float erf, inverse, log, oneMinusExp;
    float power, cos, sin, unused;
};

/// Small and large arguments, the ends of each function's polynomials among them.
std::vector<In> grid() {
    std::vector<In> inputs;
    RandomInputs random(81);
    const float ends[] = {0, 1e-7F, 0.25F, 0.5F, 1 - 0x1p-24F};
    for (int i = 0; i < 4000; ++i) {
        const auto power = [&](float low, float high) {
            return std::exp(random.between(std::log(low), std::log(high)));
        };
        In in{random.between(-6, 6),
              i < 5 ? ends[i] : random.unit(),
              power(1e-8F, 1e8F),
              -power(1e-8F, 80),
              power(1e-12F, 1e3F),
              power(1e-3F, 1e6F),
              i < 5 ? ends[i] : random.unit(),
              power(1, 1e6F)};
        if (i % 3 == 0) in.q = power(1e-12F, 0.5F);
        if (i % 3 == 0) in.t = -random.unit();
        if (i % 4 == 0) in.x = power(1e-6F, 1);
        inputs.push_back(in);
    }
    return inputs;
}

/// The x of erf(x) = 2q - 1 by bisection, within [-5, 5].
double inverseErf(double q) {
    double low = -5, high = 5;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle) < q ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

void compare(const In& in, const Out& out, Findings& findings) {
    findings.near("erf", out.erf, std::erf(double{in.x}), 3e-7);
    // What the rounding of 2q - 1 moves x by, near q = 1.
    const double x = inverseErf(in.q), rounding = 0x1p-24 * std::exp(x * x) * (in.q > 0.5F ? 1 : 0);
    findings.near("inverse of erf", out.inverse, x, 4e-6 + 2 * std::min(rounding, 1.0));
    findings.near("ln(1 + t)", out.log, std::log1p(double{in.t}), 1e-30, 6e-7);
    findings.near("1 - exp", out.oneMinusExp, -std::expm1(double{in.y}), 1e-30, 1e-6);
    const double exponent = 0.5 * double{in.e} * std::log1p(double{in.tan2});
    findings.near("power of a cosine", out.power, std::exp(-exponent), 1e-37, 3e-6 + 1e-6 * exponent);
    const double l = std::log1p(-double{in.u}) / double{in.n};
    findings.near("cosine of a power", out.cos, std::exp(l), 0, 4e-6);
    findings.near("sine of a power", out.sin, std::sqrt(-std::expm1(2 * l)), 1e-30, 2e-6);
}

}  // namespace

void checkSpecialFunctions(VerifyContext& context, Findings& findings) {
    const auto inputs = grid();
    const auto out = context.prober().evaluate<Out>("special_functions", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("x {}, q {}, t {}, y {}, tan^2 {}, e {}, u {}, n {}", in.x, in.q, in.t, in.y, in.tan2, in.e,
                           in.u, in.n);
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compare(inputs[i], out[i], findings);
    }
}

}  // namespace vkpt
