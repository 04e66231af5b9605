// Sets of sample indices: which samples of a render a film holds.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

/// Sample indices [begin, end).
struct SampleRange {
    std::uint32_t begin = 0, end = 0;

    [[nodiscard]] std::uint32_t count() const { return end - begin; }
    friend bool operator==(const SampleRange&, const SampleRange&) = default;
};

/// Ascending; no range is empty, none touches the next.
using SampleRanges = std::vector<SampleRange>;

[[nodiscard]] std::uint32_t countSamples(const SampleRanges& ranges);

/// The first indices that both hold; nothing where they are disjoint.
[[nodiscard]] std::optional<SampleRange> overlapOf(const SampleRanges& a, const SampleRanges& b);

[[nodiscard]] SampleRanges unite(const SampleRanges& a, const SampleRanges& b);

/// What of `whole` is not in `held`, in ascending order.
[[nodiscard]] SampleRanges missingFrom(const SampleRange& whole, const SampleRanges& held);

/// "0:32,48:64"; "none" where there are none.
[[nodiscard]] std::string rangesText(const SampleRanges& ranges);

/// The inverse of rangesText; nothing where the text is malformed or not ascending.
[[nodiscard]] std::optional<SampleRanges> parseSampleRanges(std::string_view text);

}  // namespace vkpt
