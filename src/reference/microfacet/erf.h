// The error function and its inverse from published polynomials, so that both renderers round alike. [Moshier 89],
// [Giles 11] Real = double is the truth: the standard library, and Newton's steps where it has no function.
#pragma once
#include <type_traits>

#include "reference/real.h"

namespace vkpt::reference {

template <class Real>
inline constexpr Real kSqrtPi = Real(1.77245385090551602729816748334114518L);

/// coefficients[0] x^n + coefficients[1] x^(n-1) + ...
template <class Real, std::size_t n>
[[nodiscard]] Real polynomial(Real x, const Real (&coefficients)[n]) {
    Real sum = coefficients[0];
    for (std::size_t i = 1; i < n; ++i) sum = sum * x + coefficients[i];
    return sum;
}

/// 1 - erf(x), relative error about 4e-6 at most in float, for infinities too.
template <class Real>
[[nodiscard]] Real complementaryErrorFunction(Real x);

/// erf(x), error below 2e-7 in float.
template <class Real>
[[nodiscard]] Real errorFunction(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::erf(x);
    } else {
        if (std::abs(x) > 1) return 1 - complementaryErrorFunction(x);
        constexpr Real kSmall[] = {Real(7.853861353153693e-5), Real(-8.010193625184903e-4),
                                   Real(5.188327685732524e-3), Real(-2.685381193529856e-2),
                                   Real(1.128358514861418e-1), Real(-3.761262582423300e-1),
                                   Real(1.128379165726710)};
        return x * polynomial(x * x, kSmall);
    }
}

template <class Real>
Real complementaryErrorFunction(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::erfc(x);
    } else {
        const Real a = std::abs(x);
        if (a < 1) return 1 - errorFunction(x);
        if (a > 9) return x < 0 ? Real(2) : Real(0);
        constexpr Real kMiddle[] = {
            Real(2.326819970068386e-2),  Real(-1.387039388740657e-1), Real(3.687424674597105e-1),
            Real(-5.824733027278666e-1), Real(6.210004621745983e-1),  Real(-4.944515323274145e-1),
            Real(3.404879937665872e-1),  Real(-2.741127028184656e-1), Real(5.638259427386472e-1)};
        constexpr Real kLarge[] = {Real(-1.047766399936249e1),  Real(1.297719955372516e1), Real(-7.495518717768503),
                                   Real(2.921019019210786),     Real(-1.015265279202700),  Real(4.218463358204948e-1),
                                   Real(-2.820767439740514e-1), Real(5.641895067754075e-1)};
        const Real q = 1 / a, p = a < 2 ? polynomial(q * q, kMiddle) : polynomial(q * q, kLarge);
        const Real y = std::exp(-a * a) * q * p;
        return x < 0 ? 2 - y : y;
    }
}

/// The x of which erf(x) = y, for |y| < 1. [Giles 11, single precision]
template <class Real>
[[nodiscard]] Real inverseErrorFunction(Real y) {
    constexpr Real kCentre[] = {Real(2.81022636e-8),  Real(3.43273939e-7), Real(-3.5233877e-6),
                                Real(-4.39150654e-6), Real(2.1858087e-4),  Real(-1.25372503e-3),
                                Real(-4.17768164e-3), Real(2.46640727e-1), Real(1.50140941)};
    constexpr Real kTail[] = {Real(-2.00214257e-4), Real(1.00950558e-4), Real(1.34934322e-3),
                              Real(-3.67342844e-3), Real(5.73950773e-3), Real(-7.6224613e-3),
                              Real(9.43887047e-3),  Real(1.00167406),    Real(2.83297682)};
    const Real w = -std::log((1 - y) * (1 + y));
    Real x = y * (w < 5 ? polynomial(w - Real(2.5), kCentre) : polynomial(std::sqrt(w) - 3, kTail));
    if constexpr (std::is_same_v<Real, double>) {
        constexpr int kNewtonSteps = 3;
        for (int i = 0; i < kNewtonSteps; ++i) {  // on the side where 1 - erf keeps its digits
            const Real miss = y < 0 ? (1 + y) - std::erfc(-x) : std::erfc(x) - (1 - y);
            x += miss * kSqrtPi<Real> / 2 * std::exp(x * x);
        }
    }
    return x;
}

}  // namespace vkpt::reference
