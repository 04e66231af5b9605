#include "scene/light_layers.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

constexpr std::size_t kMostLetters = 48;  ///< of a name, well below EXR's 255 with its channel

bool isPlain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string plainName(const std::string& group) {
    std::string name = "light_";
    for (const char c : group.substr(0, kMostLetters)) name += isPlain(c) ? c : '_';
    return name;
}

}  // namespace

std::uint32_t lengthLayers(std::uint32_t depth) { return std::min(depth, kMostLengthLayers - 1) + 1; }

std::string lengthLayerName(std::uint32_t layer) {
    if (layer == 0) return "emission";
    if (layer == 1) return "direct";
    return fmt::format("bounce{}{}", layer - 1, layer + 1 == kMostLengthLayers ? "_and_more" : "");
}

std::vector<std::string> groupLayerNames(const std::vector<std::string>& groups) {
    std::vector<std::string> names;
    for (const std::string& group : groups) {
        const std::string plain = plainName(group);
        std::string name = plain;
        for (int i = 2; std::ranges::find(names, name) != names.end(); ++i) name = fmt::format("{}_{}", plain, i);
        names.push_back(std::move(name));
    }
    return names;
}

}  // namespace vkpt
