// Arrays in, arrays out: runs one small kernel and reads what it wrote.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gpu/kernel.h"

namespace vkpt {

/// Invocations in a work group of every probe kernel.
inline constexpr std::uint32_t kProbeGroupSize = 64;

/// What a probe takes beside its arrays.
struct ProbeOptions {
    std::vector<std::uint32_t> push{};            ///< push constant words after `count`
    std::vector<std::uint32_t> specialization{};  ///< constant_id = i has value [i]
    std::vector<BindingKind> extraKinds{};        ///< kinds of bindings 2, 3, …
    std::vector<Binding> extra{};                 ///< what is bound there
};

/// A kernel with binding 0 = input, binding 1 = output (both storage buffers), `options.extraKinds` after them, 64
/// invocations a group and push constants {uint count; options.push…}. It returns early where
/// gl_GlobalInvocationID.x >= count.
[[nodiscard]] Kernel makeProbeKernel(Device& device, std::span<const std::uint32_t> spirv, std::string_view name,
                                     const ProbeOptions& options = {});

/// Runs `count` invocations of such a kernel; the output is zeroed first.
[[nodiscard]] std::vector<std::byte> runProbe(Device& device, const Kernel& kernel, std::span<const std::byte> input,
                                              std::size_t outputBytes, std::uint32_t count,
                                              const ProbeOptions& options = {});

/// Both at once.
[[nodiscard]] std::vector<std::byte> runProbe(Device& device, std::span<const std::uint32_t> spirv,
                                              std::string_view name, std::span<const std::byte> input,
                                              std::size_t outputBytes, std::uint32_t count,
                                              const ProbeOptions& options = {});

/// One invocation an input; each writes `outputsEach` values of Out.
template <class Out, class Inputs>
[[nodiscard]] std::vector<Out> probe(Device& device, std::span<const std::uint32_t> spirv, std::string_view name,
                                     const Inputs& inputs, std::size_t outputsEach = 1,
                                     const ProbeOptions& options = {}) {
    const std::span in(inputs);
    static_assert(std::is_trivially_copyable_v<Out>);
    const std::vector<std::byte> bytes =
        runProbe(device, spirv, name, std::as_bytes(in), in.size() * outputsEach * sizeof(Out),
                 static_cast<std::uint32_t>(in.size()), options);
    const Out* first = reinterpret_cast<const Out*>(bytes.data());
    return {first, first + in.size() * outputsEach};
}

}  // namespace vkpt
