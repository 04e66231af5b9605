#include "scene/aov.h"

#include <algorithm>

namespace vkpt {

std::string aovsText(AovSet aovs) {
    std::string text;
    for (const AovInfo& aov : kAovs)
        if (aovs.has(aov.id)) text.append(text.empty() ? "" : ",").append(aov.name);
    return text.empty() ? "none" : text;
}

std::optional<AovSet> parseAovs(std::string_view text) {
    if (text == "all") return kAllAovs;
    if (text == "none") return AovSet{};
    AovSet aovs;
    for (;;) {
        const std::size_t comma = text.find(',');
        const auto aov = std::ranges::find(kAovs, text.substr(0, comma), &AovInfo::name);
        if (aov == kAovs.end()) return std::nullopt;
        aovs.add(aov->id);
        if (comma == std::string_view::npos) return aovs;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace vkpt
