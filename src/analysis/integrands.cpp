#include "analysis/integrands.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace vkpt {
namespace {

double disc(const double* x) { return x[0] * x[0] + x[1] * x[1] < 2 / std::numbers::pi ? 1 : 0; }
double bilinear(const double* x) { return x[0] * x[1]; }
double gaussian(const double* x) { return std::exp(-x[0] * x[0] - x[1] * x[1]); }

double additive4(const double* x) { return x[0] * x[0] + std::sin(x[1]) + std::sqrt(x[2]) + x[3]; }

/// A product of factors that are 1 on average and as far from additive as their amplitude.
template <int Dims>
double product(const double* x) {
    double value = 1;
    for (int d = 0; d < Dims; ++d) value *= 1 + 1.2 * (x[d] - 0.5);
    return value;
}

const double kErf1 = std::sqrt(std::numbers::pi) / 2 * std::erf(1.0);

}  // namespace

const std::array<Integrand, 6> kIntegrands{{
    {"disc", 2, disc, 0.5, "quarter disc of area 1/2: a step"},
    {"bilinear", 2, bilinear, 0.25, "x y"},
    {"gaussian", 2, gaussian, kErf1* kErf1, "exp(-x^2 - y^2)"},
    {"additive4", 4, additive4, 1.0 / 3 + (1 - std::cos(1.0)) + 2.0 / 3 + 0.5, "a sum of functions of one variable"},
    {"product4", 4, product<4>, 1, "product of 1 + 1.2 (x - 1/2) in 4 dimensions"},
    {"product8", 8, product<8>, 1, "the same in 8 dimensions"},
}};

const Integrand& integrandNamed(std::string_view name) {
    for (const Integrand& integrand : kIntegrands)
        if (integrand.name == name) return integrand;
    throw std::out_of_range("no integrand " + std::string(name));
}

}  // namespace vkpt
