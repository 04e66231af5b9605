// One pixel's paths on both sides, vertex by vertex, until they part.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"

namespace vkpt {

class VerifyContext;

/// One thing about a vertex, on both sides.
struct ReplayRow {
    std::string name;
    std::string device, reference;  ///< "-" where a side has none
    bool same = true;               ///< up to kReplayRelative of the larger
};
inline constexpr double kReplayRelative = 1e-3;

struct ReplayVertex {
    std::uint32_t bounce = 0;
    std::vector<ReplayRow> rows;
};

struct ReplayPath {
    std::uint32_t sample = 0;
    std::vector<ReplayVertex> vertices;  ///< up to the one at which the paths part

    /// The first row that differs; nothing where the paths are the same.
    struct Parting {
        std::uint32_t bounce = 0;
        std::string row, device, reference;
    };
    [[nodiscard]] std::optional<Parting> parting() const;
};

/// Replays samples [begin, end) of pixel (x, y).
[[nodiscard]] std::vector<ReplayPath> replayPixel(VerifyContext& context, std::uint32_t x, std::uint32_t y,
                                                  std::uint32_t begin, std::uint32_t end);

[[nodiscard]] std::string replayText(const std::vector<ReplayPath>& paths);
[[nodiscard]] Json replayJson(const std::vector<ReplayPath>& paths);

}  // namespace vkpt
