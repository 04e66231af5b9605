#include "scene/sample_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vkpt {
namespace {

/// Reads a number off the front of `text`.
std::optional<std::uint32_t> takeNumber(std::string_view& text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool takeCharacter(std::string_view& text, char wanted) {
    if (!text.starts_with(wanted)) return false;
    text.remove_prefix(1);
    return true;
}

}  // namespace

std::uint32_t countSamples(const SampleRanges& ranges) {
    std::uint32_t samples = 0;
    for (const SampleRange& range : ranges) samples += range.count();
    return samples;
}

std::optional<SampleRange> overlapOf(const SampleRanges& a, const SampleRanges& b) {
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
        const SampleRange both{std::max(i->begin, j->begin), std::min(i->end, j->end)};
        if (both.begin < both.end) return both;
        i->end < j->end ? ++i : ++j;
    }
    return std::nullopt;
}

SampleRanges unite(const SampleRanges& a, const SampleRanges& b) {
    SampleRanges all(a), united;
    all.insert(all.end(), b.begin(), b.end());
    std::ranges::sort(all, {}, &SampleRange::begin);
    for (const SampleRange& range : all) {
        if (!united.empty() && range.begin <= united.back().end)
            united.back().end = std::max(united.back().end, range.end);
        else
            united.push_back(range);
    }
    return united;
}

SampleRanges missingFrom(const SampleRange& whole, const SampleRanges& held) {
    SampleRanges missing;
    std::uint32_t at = whole.begin;
    for (const SampleRange& range : held) {
        const std::uint32_t end = std::min(range.begin, whole.end);
        if (at < end) missing.push_back({at, end});
        at = std::max(at, range.end);
    }
    if (at < whole.end) missing.push_back({at, whole.end});
    return missing;
}

std::string rangesText(const SampleRanges& ranges) {
    if (ranges.empty()) return "none";
    std::string text;
    for (const SampleRange& range : ranges)
        text += fmt::format("{}{}:{}", text.empty() ? "" : ",", range.begin, range.end);
    return text;
}

std::optional<SampleRanges> parseSampleRanges(std::string_view text) {
    SampleRanges ranges;
    if (text == "none") return ranges;
    do {
        const auto begin = takeNumber(text);
        if (!begin || !takeCharacter(text, ':')) return std::nullopt;
        const auto end = takeNumber(text);
        if (!end || *begin >= *end || (!ranges.empty() && *begin <= ranges.back().end)) return std::nullopt;
        ranges.push_back({*begin, *end});
    } while (takeCharacter(text, ','));
    return text.empty() ? std::optional(ranges) : std::nullopt;
}

}  // namespace vkpt
