// The version a picture's metadata states. Equal to the project's in CMakeLists.txt (a test checks).
#pragma once
#include <string_view>

namespace vkpt {

inline constexpr std::string_view kVersion = "0.1.0";
inline constexpr std::string_view kSoftware = "vkpt 0.1.0";

}  // namespace vkpt
