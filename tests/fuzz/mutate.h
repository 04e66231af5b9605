// Mutations that keep a glTF file a glTF file, so that they reach beyond the parser.
#pragma once
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace vkpt::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Changes some bytes of a buffer in place.
using MutateBytes = std::function<void(Bytes&)>;

/// Another file made from a .gltf or .glb: some values of its JSON replaced, removed, repeated or exchanged, or its
/// binary chunk changed by `mutateBytes`. What is no glTF goes to `mutateBytes` whole.
[[nodiscard]] Bytes mutateGltf(std::span<const std::uint8_t> file, std::mt19937& random,
                               const MutateBytes& mutateBytes);

}  // namespace vkpt::fuzz
