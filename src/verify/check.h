// The table of checks: what is compared between the device and the reference, rung by rung of the ladder.
// `vkpt verify` climbs it; tests/verify loops over it. A new check: its function, and one line in checks.cpp.
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "verify/findings.h"

namespace vkpt {

class VerifyContext;

/// From what is simplest to what is whole. A rung is believed where those below it hold.
enum class Rung : std::uint32_t { Layout, Integers, Functions, Stages, SameSeed, OtherSeeds };

struct RungInfo {
    std::string_view name, about;
};
inline constexpr std::array kRungs = {
    RungInfo{"layout", "every field of the shared structs, read back"},
    RungInfo{"integers", "random bits, hashes, tables, sums, queues: equality"},
    RungInfo{"functions", "every shader function over grids and random inputs, within stated tolerances"},
    RungInfo{"stages", "every kernel of every bounce, from the device's own state"},
    RungInfo{"same seed", "images of the same random numbers, path by path"},
    RungInfo{"other seeds", "images of other random numbers, by Welch's t-test on replicates"}};

struct Check {
    Rung rung;
    std::string_view name;
    std::string_view about;  ///< what is compared, how closely
    void (*run)(VerifyContext& context, Findings& findings);
};

/// All of them, in the order of their rungs.
[[nodiscard]] std::span<const Check> verifyChecks();

}  // namespace vkpt
