// Text of unknown origin, made safe to print.
#pragma once
#include <algorithm>
#include <string>

namespace vkpt {

/// Control characters become question marks: names in a file may not break a message's line or steer a terminal.
[[nodiscard]] inline std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
}

}  // namespace vkpt
