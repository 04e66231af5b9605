// Where the code of kernels comes from.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace vkpt {

/// SPIR-V of the kernel `name`; empty where there is none. The words live as long as whatever handed out the source.
using SpirvSource = std::function<std::span<const std::uint32_t>(std::string_view name)>;

}  // namespace vkpt
