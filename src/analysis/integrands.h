// Integrals over the unit cube whose values are known.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace vkpt {

struct Integrand {
    std::string_view name;
    std::size_t dims;
    double (*value)(const double* x);
    double integral;
    std::string_view about;
};

/// The disc and the Gaussian are those of [Christensen 18].
extern const std::array<Integrand, 6> kIntegrands;

/// Throws std::out_of_range for a name that kIntegrands does not hold.
[[nodiscard]] const Integrand& integrandNamed(std::string_view name);

}  // namespace vkpt
